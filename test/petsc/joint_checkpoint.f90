!> A run that is kept after a stroke, read by another process and continued is the run that was
!> not interrupted, bit for bit.
module test_petsc_joint_checkpoint
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: error_type, wp
   use asperity_solid_model_model, only: solid_model
   use asperity_solid_solve_checkpoint, only: read_run, write_run
   use asperity_solid_solve_programme, only: new_solid_run, run_programme, solid_run
   use test_petsc_engine, only: petsc
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertTrue, TestMethod, TestSuite
   use joint_cases, only: joint_case, new_joint, run_of, stopper
   implicit none
   private
   public :: suite_joint_checkpoint

contains

   function suite_joint_checkpoint() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('checkpoint of the joint')
      call suite%addTest(TestMethod('cut is uncut, rough', test_rough))
      call suite%addTest(TestMethod('cut is uncut, hard', test_hard))
      call suite%addTest(TestMethod('another joint is refused', test_refused))
   end function suite_joint_checkpoint

   subroutine test_rough()
      call compare(joint_case('rough', amplitudes=[8.0_wp, 24.0_wp]))
   end subroutine test_rough

   subroutine test_hard()
      call compare(joint_case('hard', amplitudes=[8.0_wp, 24.0_wp]))
   end subroutine test_hard

   !> Cut after the beam was fitted and after strokes in which faces have met more of the beam.
   subroutine compare(given)
      type(joint_case), intent(in) :: given
      type(joint_case) :: case
      integer, parameter :: cuts(3) = [0, 2, 4]
      type(solid_run) :: uncut, cut, continued
      type(solid_model) :: model
      type(stopper) :: watcher
      type(error_type), allocatable :: error
      integer :: i, unit, status

      case = given
      ! so near that patterns grow within strokes
      case%settings%search_distance = 1.0e-3_wp
      call run_of(uncut, case)
      do i = 1, size(cuts)
         call run_of(cut, case, stopper(strokes=cuts(i)))
         open (newunit=unit, access='stream', form='unformatted', status='scratch', &
            action='readwrite')
         call write_run(unit, cut, status)
         call assertEqual(0, status, message='written')
         rewind (unit)
         call new_joint(model, case)
         call new_solid_run(continued, model, petsc, error)
         call read_run(unit, continued, status)
         close (unit)
         call assertEqual(0, status, message='read')
         call run_programme(continued, watcher, error)
         call assertFalse(allocated(error))
         call assertTrue(has_same_bits(uncut, continued), 'bits')
         call assertEqual([uncut%increments, uncut%iterations, uncut%cutbacks], &
            [continued%increments, continued%iterations, continued%cutbacks], message='counts')
      end do
      ! the rough law's faces meet all they need at once
      if (case%contact == 'hard') call assertGreaterThan(uncut%system%solver%n_patterns, &
         size(uncut%model%turns), message='patterns that grew')
   end subroutine compare

   !> Records, displacements and points.
   logical function has_same_bits(run, other)
      type(solid_run), intent(in) :: run, other
      integer(int64) :: mould(1)

      has_same_bits = .false.
      if (size(run%records) /= size(other%records)) return
      has_same_bits = all(transfer(numbers(run), mould) == transfer(numbers(other), mould))
   end function has_same_bits

   function numbers(run)
      type(solid_run), intent(in) :: run
      real(wp), allocatable :: numbers(:)
      integer :: i, j

      numbers = reshape(run%displacement, [size(run%displacement)])
      do i = 1, size(run%records)
         associate (r => run%records(i))
            numbers = [numbers, real(r%stroke, wp), real(r%iterations, wp), r%displacement, &
               r%force, r%rotation, r%pull_out, r%work, r%stored, r%plastic, r%friction, &
               r%coupling, r%edge, r%balance, r%yielding, r%plastic_strain, r%normal_force, &
               r%largest_pressure, r%largest_mean_pressure, r%stick_area, r%slip_area, &
               r%friction_energy, real(r%validity, wp)]
         end associate
      end do
      do j = 1, size(run%model%points, 2)
         do i = 1, 8
            associate (point => run%model%points(i, j))
               numbers = [numbers, point%stress, point%plastic_strain, point%equivalent_strain]
            end associate
         end do
      end do
   end function numbers

   !> A joint of another mesh, with other cells, and a file that ends too early.
   subroutine test_refused()
      type(joint_case) :: case, other
      type(solid_run) :: run, wrong
      type(solid_model) :: model
      type(error_type), allocatable :: error
      integer :: i, unit, status

      case = joint_case(amplitudes=[8.0_wp])
      call run_of(run, case, stopper(strokes=0))
      open (newunit=unit, access='stream', form='unformatted', status='scratch', &
         action='readwrite')
      call write_run(unit, run, status)
      do i = 1, 2
         other = case
         if (i == 1) other%mesh_size = 60.0_wp
         if (i == 2) other%settings%cells = 4
         call new_joint(model, other)
         call new_solid_run(wrong, model, petsc, error)
         rewind (unit)
         call read_run(unit, wrong, status)
         call assertGreaterThan(status, 0, message='another joint')
      end do
      close (unit)
      open (newunit=unit, access='stream', form='unformatted', status='scratch', &
         action='readwrite')
      write (unit) 0, 6
      rewind (unit)
      call new_joint(model, case)
      call new_solid_run(wrong, model, petsc, error)
      call read_run(unit, wrong, status)
      call assertTrue(status /= 0, 'too short')
      close (unit)
   end subroutine test_refused

end module test_petsc_joint_checkpoint
