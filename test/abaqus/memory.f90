!> UINTER with elastic unloading: PROPS(14), SED and SPD, STATEV(7), perturbation steps.
module test_abaqus_memory
   use abaqus_stubs, only: forget_calls, last_message, messages
   use asperity, only: contact_properties, contact_response, contact_state, error_type, &
      no_rotation, unloading_elastic, unloading_stiffness, update_contact_point, wp
   use asperity_abaqus_prop_slots, only: n_props
   use asperity_abaqus_props, only: props_from_properties
   use asperity_abaqus_statev, only: n_statev, state_largest_closure, state_normal_energy, &
      state_overclosure
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_replay_abaqus_host, only: accept_increment, host_point, host_response, &
      new_host_point, try_increment
   use contact_cases, only: pair_properties
   use funit, only: anyExceptions, assertEqual, assertFalse, assertGreaterThan, assertTrue, &
      TestMethod, TestSuite
   implicit none
   private
   public :: suite_abaqus_memory

   procedure(uinter_interface) :: uinter
   real(wp), parameter :: dtime = 1.0_wp
   integer, parameter :: unloading_slot = 14

contains

   function suite_abaqus_memory() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('abaqus memory')
      call suite%addTest(TestMethod('as the contact-point update, with SED and SPD', test_same))
      call suite%addTest(TestMethod('perturbation at the largest closure', test_perturbation))
      call suite%addTest(TestMethod('STATEV written without memory', test_older_state))
      call suite%addTest(TestMethod('what is refused', test_refused))
   end function suite_abaqus_memory

   subroutine test_same()
      type(contact_properties) :: p
      type(host_point) :: point
      type(contact_response) :: r, seen
      type(error_type), allocatable :: error
      real(wp), parameter :: path(3, 6) = reshape([0.05_wp, 0.1_wp, 0.1_wp, 0.12_wp, 0.4_wp, &
         0.0_wp, 0.118_wp, -0.2_wp, 0.3_wp, 0.119_wp, 0.1_wp, 0.0_wp, 0.13_wp, 0.1_wp, 0.0_wp, &
         0.0_wp, 0.0_wp, 0.0_wp], [3, 6])
      real(wp) :: flattened, lost
      integer :: i

      p = pair_properties(unloading=unloading_elastic)
      call new_host_point(point, uinter, p)
      flattened = 0.0_wp
      lost = 0.0_wp
      do i = 1, 6
         call try_increment(point, path(1, i), path(2:, i), dtime, error)
         call assertFalse(allocated(error), 'UINTER kept its contract')
         call update_contact_point(p, (r%state), path(1, i), path(2:, i), no_rotation, r)
         call assertEqual(r%traction, point%trial%stress, 0.0_wp, 'stress')
         call assertEqual(reshape(r%tangent, [9]), reshape(point%trial%ddsddr, [9]), 0.0_wp, &
            'tangent')
         call assertEqual(r%normal_energy + r%tangential_energy, point%trial%sed, 0.0_wp, 'SED')
         call assertEqual(r%dissipation, point%trial%sfd, 0.0_wp, 'SFD')
         call assertEqual(r%plastic_dissipation, point%trial%spd, 0.0_wp, 'SPD')
         call assertEqual([r%normal_energy, path(1, i), maxval(path(1, :i))], &
            point%trial%statev([state_normal_energy, state_overclosure, state_largest_closure]), &
            0.0_wp, 'STATEV')
         seen = host_response(point)
         call assertEqual(r%plastic_dissipation, seen%plastic_dissipation, 0.0_wp, 'of the host')
         flattened = flattened + point%trial%spd
         lost = lost + point%trial%sfd
         call accept_increment(point)
         if (anyExceptions()) return
      end do
      call assertGreaterThan(flattened, 0.03_wp, 'summits were flattened')
      call assertGreaterThan(lost, 0.01_wp, 'and slid')
   end subroutine test_same

   subroutine test_perturbation()
      type(contact_properties) :: p
      type(host_point) :: point
      type(error_type), allocatable :: error

      p = pair_properties(unloading=unloading_elastic)
      call new_host_point(point, uinter, p)
      call try_increment(point, 0.1_wp, [0.1_wp, 0.05_wp], dtime, error)
      call accept_increment(point)
      call try_increment(point, -1.0e-6_wp, [0.0_wp, 0.0_wp], dtime, error, linper=1)
      call assertEqual(unloading_stiffness(p%normal, p%initial_separation - 0.1_wp), &
         point%trial%ddsddr(1, 1), 0.0_wp, 'the stiffness of unloading')
      call assertEqual(0.0_wp, point%trial%spd, 0.0_wp, 'nothing is flattened')
   end subroutine test_perturbation

   !> A job without memory goes on with it: its largest closure is what is remembered.
   subroutine test_older_state()
      type(contact_properties) :: p
      type(host_point) :: point, older
      type(contact_response) :: r
      type(error_type), allocatable :: error

      call new_host_point(older, uinter, pair_properties())
      call try_increment(older, 0.12_wp, [0.0_wp, 0.0_wp], dtime, error)
      call accept_increment(older)
      call try_increment(older, 0.1_wp, [0.0_wp, 0.0_wp], dtime, error)
      call accept_increment(older)
      p = pair_properties(unloading=unloading_elastic)
      call new_host_point(point, uinter, p)
      point%start%statev = older%start%statev
      call try_increment(point, 0.115_wp, [0.0_wp, 0.0_wp], dtime, error)
      call update_contact_point(p, contact_state(), 0.12_wp, [0.0_wp, 0.0_wp], no_rotation, r)
      call update_contact_point(p, (r%state), 0.115_wp, [0.0_wp, 0.0_wp], no_rotation, r)
      call assertEqual(r%traction, point%trial%stress, 0.0_wp, 'as if it had been there')
   end subroutine test_older_state

   subroutine test_refused()
      real(wp) :: props(n_props), statev(n_statev)

      props = props_from_properties(pair_properties(unloading=unloading_elastic))
      call assertEqual(1.0_wp, props(unloading_slot), 0.0_wp, 'elastic')
      statev = 0.0_wp
      call expect(1.0_wp, statev, '')
      call expect(0.0_wp, statev, '')
      call expect(2.0_wp, statev, 'PROPS(14) = 2.0 is not allowed: the unloading is 0 for '// &
         'reversible, 1 for elastic')
      call expect(0.5_wp, statev, 'PROPS(14) = 0.5 is not allowed')
      call expect(-1.0_wp, statev, 'PROPS(14) = -1.0 is not allowed')
      statev(1) = 2.0_wp
      statev(2) = 0.1_wp
      statev(7) = 0.1_wp
      call expect(1.0_wp, statev, '')
      statev(7) = nearest(0.1_wp, -1.0_wp)
      call expect(1.0_wp, statev, 'STATEV(7) = 0.09999999999999999 is below STATEV(2) = 0.1')
      call expect(0.0_wp, statev, 'is below STATEV(2)')
      props(8) = 0.15_wp
      statev = 0.0_wp
      call expect(1.0_wp, statev, 'yield_factor = 0.15 is not allowed with elastic unloading')
      call expect(0.0_wp, statev, '')

   contains

      !> The message that ends the job, or none.
      subroutine expect(unloading, statev, text)
         real(wp), intent(in) :: unloading, statev(:)
         character(len=*), intent(in) :: text
         type(host_point) :: point
         type(error_type), allocatable :: error

         call forget_calls()
         props(unloading_slot) = unloading
         call new_host_point(point, uinter, pair_properties(), props=props)
         point%start%statev = statev
         ! not to be warned of
         point%start%statev(11) = 255.0_wp
         call try_increment(point, 0.05_wp, [0.0_wp, 0.0_wp], dtime, error)
         if (text == '') then
            call assertEqual(0, messages, 'nothing to say')
         else
            call assertGreaterThan(messages, 0, message='refused')
            call assertTrue(index(last_message, text) > 0, text//' in: '//trim(last_message))
         end if
      end subroutine expect

   end subroutine test_refused

end module test_abaqus_memory
