!> The tenon joint with summits that stick each for itself.
module test_replay_tenon_stick
   use asperity, only: contact_properties, error_type, find_pair, new_contact_properties, &
      pair_preset, wp
   use asperity_contact_friction_settings, only: friction_settings, stick_summits
   use asperity_replay_tenon_settings, only: tenon_settings
   use asperity_replay_tenon_step, only: tenon_step
   use extremes, only: largest_of
   use funit, only: anyExceptions, assertFalse, assertGreaterThan, assertLessThan, TestMethod, &
      TestSuite
   use measurements, only: record
   use tenon_cases, only: face_pair, plain_joint, run_joint
   implicit none
   private
   public :: suite_tenon_stick

contains

   function suite_tenon_stick() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('tenon stick')
      call suite%addTest(TestMethod('ledgers close with order two in the step', test_order))
      call suite%addTest(TestMethod('through UINTER and without', test_uinter))
      call suite%addTest(TestMethod('hard contact has no summits', test_hard))
   end function suite_tenon_stick

   !> Upper and lower face of summits that stick.
   function sticking_faces() result(faces)
      type(contact_properties) :: faces
      type(pair_preset) :: pair
      type(error_type), allocatable :: error

      call find_pair('transverse-tangential', pair, error)
      call new_contact_properties(faces, pair, error, &
         friction=friction_settings(stick=stick_summits, shear_modulus=31.6_wp))
      call assertFalse(allocated(error), 'faces')
   end function sticking_faces

   !> A rough joint that slides along its own axis.
   function sliding_joint(increment) result(settings)
      real(wp), intent(in) :: increment
      type(tenon_settings) :: settings

      settings = plain_joint()
      settings%contact = 'rough'
      settings%axial_rule = 'spring'
      settings%axial_stiffness = 100.0_wp
      settings%amplitudes = [16.0_wp]
      settings%points = 30
      settings%displacement_increment = increment
   end function sliding_joint

   !> Work of the points against stored energy, dissipation and coupling: order 2 is 16 for two
   !> halvings, while summits let go within a step at random.
   subroutine test_order()
      type(tenon_step), allocatable :: steps(:)
      real(wp) :: rest(2)
      integer :: i

      do i = 1, 2
         call run_joint(sliding_joint(0.4_wp/4.0_wp**i), steps, sticking_faces())
         if (anyExceptions()) return
         associate (first => steps(0), last => steps(ubound(steps, 1)))
            rest(i) = abs(last%contact_work - (last%stored - first%stored + last%friction &
               + last%plastic + last%edge - last%elastic_slip))/last%work
         end associate
      end do
      call record('tenon.summits.energy_rest', rest(2))
      call assertLessThan(rest(2), rest(1)/8.0_wp, 'falls with order two')
      call assertLessThan(rest(2), 1.0e-3_wp, 'is small')
   end subroutine test_order

   !> States of the elements in STATEV.
   subroutine test_uinter()
      type(tenon_settings) :: settings
      type(tenon_step), allocatable :: direct(:), through(:)

      settings = sliding_joint(0.4_wp)
      call run_joint(settings, direct, sticking_faces())
      settings%through_uinter = .true.
      call run_joint(settings, through, sticking_faces())
      if (anyExceptions()) return
      call assertLessThan(largest_of(direct%moment - through%moment)/maxval(direct%moment), &
         1.0e-8_wp, 'moment')
   end subroutine test_uinter

   !> gcrit holds there.
   subroutine test_hard()
      type(tenon_settings) :: settings
      type(tenon_step), allocatable :: plain(:), sticking(:)

      settings = sliding_joint(0.4_wp)
      settings%contact = 'hard'
      call run_joint(settings, plain, face_pair())
      call run_joint(settings, sticking, sticking_faces())
      if (anyExceptions()) return
      call assertGreaterThan(maxval(plain%moment), 0.0_wp, 'a moment')
      call assertLessThan(largest_of(plain%moment - sticking%moment), tiny(1.0_wp), 'the same')
   end subroutine test_hard

end module test_replay_tenon_stick
