!> The contact point at which an increment fails: which it is, and its motion from the start, along
!> which UINTER comes to the same tractions.
module test_solid_contact_failure
   use asperity, only: contact_properties, error_type, friction_settings, wp
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_base_error, only: fatal_error
   use asperity_contact_state, only: contact_response, contact_state
   use asperity_law_normal_properties, only: unloading_elastic
   use asperity_replay_abaqus_host, only: host_point, new_host_point
   use asperity_replay_path_replay, only: path_step, replay_path
   use asperity_solid_contact_failed_point, only: failed_point, find_failed_point, keep_motions
   use asperity_solid_engine_ranks, only: rank_team
   use asperity_solid_contact_hard, only: hard_law
   use asperity_solid_contact_law, only: solid_law
   use asperity_solid_contact_pair, only: begin_increment, contact_pair
   use asperity_solid_contact_response, only: face_response
   use asperity_solid_contact_rough, only: rough_law
   use asperity_solid_contact_uinter, only: new_uinter_law, uinter_law
   use contact_blocks, only: blocks, new_blocks
   use contact_cases, only: pair_properties
   use contact_forces, only: pair_forces
   use contact_motion, only: advance, motion, moved_master, new_motion, winding_path
   use friction_cases, only: friction_properties
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, assertTrue, &
      TestMethod, TestSuite
   implicit none
   private
   public :: suite_contact_failure

   !> The rough law, which refuses the last of so many calls.
   type, extends(rough_law) :: refusing_law
      integer :: calls = huge(1)
   contains
      procedure :: update => update_or_refuse
   end type refusing_law

   procedure(uinter_interface) :: uinter
   real(wp), parameter :: still(3) = 0.0_wp
   integer, parameter :: increments = 24

contains

   function suite_contact_failure() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('contact failure')
      call suite%addTest(TestMethod('UINTER follows the point that is refused', test_refused))
      call suite%addTest(TestMethod('the point whose force changes most', test_largest))
      call suite%addTest(TestMethod('nothing is left where nothing failed', test_none))
      call suite%addTest(TestMethod('what is kept changes no force', test_same_forces))
   end function suite_contact_failure

   !> Every point in turn, on a path over a rim and back, with friction and summits that remember.
   subroutine test_refused()
      type(refusing_law) :: law
      type(contact_properties) :: properties
      type(motion) :: m
      type(blocks) :: b
      type(failed_point) :: failed
      type(path_step), allocatable :: steps(:)
      real(wp), allocatable :: tractions(:, :, :, :)
      real(wp) :: worst, largest, last(3)
      integer :: i, j, k, cells, open_rows

      properties = friction_properties(friction_settings(decay_slip=0.2_wp, &
         static_friction_coefficient=0.7_wp, friction_coefficient_across=0.3_wp))
      properties%normal%unloading = unloading_elastic
      law%properties = properties
      b = new_blocks([3, 3], [0.0_wp, 0.0_wp], [60.0_wp, 60.0_wp], [4, 5], [-31.0_wp, -10.0_wp], &
         [50.0_wp, 70.0_wp], 0.02_wp)
      call new_motion(m, b, law)
      call keep(m)
      cells = size(m%pair%faces(1)%cells)
      allocate (tractions(3, cells, size(m%pair%faces), increments))
      do i = 1, increments
         call advance(m, winding_path(b, 0.04_wp*i))
         do j = 1, size(m%pair%faces)
            do k = 1, cells
               tractions(:, k, j, i) = m%pair%faces(j)%cells(k)%trial%traction
            end do
         end do
      end do
      worst = 0.0_wp
      open_rows = 0
      largest = maxval(abs(tractions))
      do j = 1, size(m%pair%faces)
         do k = 1, cells
            last = tried(m, winding_path(b, 0.04_wp*increments + 0.02_wp), j, k)
            call find(m, failed)
            call assertEqual([1, j, k], [failed%pair, failed%face, failed%cell], 'that point')
            steps = replayed(failed)
            call assertEqual(increments + 2, size(steps), 'first state, increments, what failed')
            do i = 1, increments
               worst = max(worst, maxval(abs(steps(i + 1)%traction - tractions(:, k, j, i))))
            end do
            worst = max(worst, maxval(abs(steps(increments + 2)%traction - last)))
            open_rows = open_rows + count(failed%path%overclosure < -1.0e30_wp)
         end do
      end do
      call assertTrue(open_rows > 100, 'points go past the rim')
      call assertGreaterThan(largest, 1.0_wp, 'there are tractions')
      call assertLessThan(worst/largest, 1.0e-12_wp, 'the same tractions')
   end subroutine test_refused

   !> Turned about two axes, the block presses most at a corner. Through UINTER it is the same.
   subroutine test_largest()
      type(rough_law) :: law
      type(uinter_law) :: through
      type(motion) :: m
      type(blocks) :: b
      type(failed_point) :: failed
      type(path_step), allocatable :: steps(:)
      integer :: i

      law%properties = pair_properties()
      call new_uinter_law(through, law%properties)
      b = new_blocks([3, 3], [0.0_wp, 0.0_wp], [60.0_wp, 60.0_wp], [4, 5], [-31.0_wp, -10.0_wp], &
         [80.0_wp, 70.0_wp], 0.02_wp)
      do i = 1, 2
         if (i == 1) call new_motion(m, b, law)
         if (i == 2) call new_motion(m, b, through)
         call keep(m)
         call advance(m, moved_master(b, [0.1_wp, 0.3_wp, -0.01_wp], still))
         call try(m, moved_master(b, [0.1_wp, 0.4_wp, -0.02_wp], [-1.0e-3_wp, 1.0e-3_wp, 0.0_wp]))
         call find(m, failed)
         call assertEqual([1, 9, 9], [failed%pair, failed%face, failed%cell], 'the corner')
         call assertEqual('the point of the path faces at x, y, z = 56.667, 56.667, 0.0 mm', &
            trim(failed%words))
         call assertEqual([0.02_wp, 0.03_wp], failed%path%overclosure(:2), 1.0e-12_wp, 'closing')
         call assertEqual([0.1_wp, 0.3_wp], abs(failed%path%slip(:, 2)), 1.0e-12_wp, 'slip')
         steps = replayed(failed)
         call assertEqual(m%pair%faces(9)%cells(9)%trial%traction, steps(3)%traction, 1.0e-12_wp, &
            'the tractions that were tried')
         call assertGreaterThan(steps(3)%traction(1), 2.0_wp*steps(2)%traction(1), 'more')
      end do
   end subroutine test_largest

   subroutine test_none()
      type(rough_law) :: law
      type(motion) :: m
      type(blocks) :: b
      type(failed_point) :: failed

      law%properties = pair_properties()
      b = new_blocks([1, 1], [0.0_wp, 0.0_wp], [10.0_wp, 10.0_wp], [2, 2], [-5.0_wp, -5.0_wp], &
         [15.0_wp, 15.0_wp], 0.02_wp)
      call new_motion(m, b, law)
      call keep(m)
      call advance(m, b%nodes)
      call find(m, failed)
      call assertEqual(0, failed%pair, 'accepted')
      call try(m, moved_master(b, [0.0_wp, 0.0_wp, 5.0_wp], still))
      call advance(m, moved_master(b, [0.0_wp, 0.0_wp, 5.0_wp], still))
      call try(m, moved_master(b, [0.0_wp, 0.0_wp, 4.0_wp], still))
      call find(m, failed)
      call assertEqual(0, failed%pair, 'open before and after')
      call assertTrue(failed%is_known, 'though kept')
      call new_motion(m, b, law)
      call advance(m, b%nodes)
      call try(m, b%nodes)
      call find(m, failed)
      call assertEqual(0, failed%pair, 'not kept')
      call assertFalse(failed%is_known, 'nothing is known')
      call new_motion(m, b, hard_law(properties=pair_properties()))
      call keep(m)
      call assertFalse(allocated(m%pair%motions), 'UINTER knows no hard contact')
   end subroutine test_none

   subroutine test_same_forces()
      type(rough_law) :: law
      type(motion) :: first, second
      type(blocks) :: b
      integer :: i

      law%properties = pair_properties()
      b = new_blocks([3, 3], [0.0_wp, 0.0_wp], [60.0_wp, 60.0_wp], [4, 5], [-31.0_wp, -10.0_wp], &
         [50.0_wp, 70.0_wp], 0.02_wp)
      call new_motion(first, b, law)
      call new_motion(second, b, law)
      call keep(second)
      ! past the room at first
      do i = 1, 70
         call advance(first, winding_path(b, 0.02_wp*i))
         call advance(second, winding_path(b, 0.02_wp*i))
         call assertTrue(all(abs(first%forces - second%forces) <= 0.0_wp), 'the same forces')
      end do
      call assertEqual(71, second%pair%motions%increments, 'kept')
   end subroutine test_same_forces

   subroutine keep(m)
      type(motion), intent(inout) :: m
      type(contact_pair) :: pairs(1)

      pairs(1) = m%pair
      call keep_motions(pairs)
      m%pair = pairs(1)
   end subroutine keep

   subroutine find(m, failed)
      type(motion), intent(in) :: m
      type(failed_point), intent(out) :: failed
      type(contact_pair) :: pairs(1)
      type(rank_team) :: alone

      pairs(1) = m%pair
      call find_failed_point(pairs, failed, alone)
   end subroutine find

   !> An increment that is not accepted.
   subroutine try(m, x)
      type(motion), intent(inout) :: m
      real(wp), intent(in) :: x(:, :)
      type(error_type), allocatable :: error
      real(wp) :: forces(3, size(x, 2))

      call begin_increment(m%pair, m%x, error)
      call pair_forces(m%pair, x, forces)
   end subroutine try

   !> The same, in which a cell is refused; its tractions if it were not.
   function tried(m, x, face, cell) result(traction)
      type(motion), intent(inout) :: m
      real(wp), intent(in) :: x(:, :)
      integer, intent(in) :: face, cell
      real(wp) :: traction(3)
      type(error_type), allocatable :: error
      real(wp), allocatable :: forces(:, :)
      integer :: i

      call try(m, x)
      traction = m%pair%faces(face)%cells(cell)%trial%traction
      select type (law => m%pair%law)
      type is (refusing_law)
         law%calls = (face - 1)*size(m%pair%faces(1)%cells) + cell
      end select
      do i = 1, face
         call face_response(m%pair, i, x, forces, error)
         if (allocated(error)) exit
      end do
      call assertTrue(allocated(error), 'refused')
      select type (law => m%pair%law)
      type is (refusing_law)
         law%calls = huge(1)
      end select
   end function tried

   !> Led through UINTER.
   function replayed(failed) result(steps)
      type(failed_point), intent(in) :: failed
      type(path_step), allocatable :: steps(:)
      type(host_point) :: point
      type(error_type), allocatable :: error

      call new_host_point(point, uinter, failed%properties, keep_history=.false.)
      call replay_path(failed%path, point, steps, error)
      call assertFalse(allocated(error), 'replayed')
   end function replayed

   subroutine update_or_refuse(law, start, overclosure, slip, response, error)
      class(refusing_law), intent(inout) :: law
      type(contact_state), intent(in) :: start
      real(wp), intent(in) :: overclosure, slip(2)
      type(contact_response), intent(out) :: response
      type(error_type), allocatable, intent(out) :: error

      law%calls = law%calls - 1
      if (law%calls == 0) then
         call fatal_error(error, 'refused')
      else
         call law%rough_law%update(start, overclosure, slip, response, error)
      end if
   end subroutine update_or_refuse

end module test_solid_contact_failure
