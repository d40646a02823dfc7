!> The contact point at which the joint fails: led along its motion from the start, UINTER comes to
!> the joint's own tractions and state.
module test_petsc_joint_failure
   use asperity, only: contact_state, error_type, wp
   use asperity_abaqus_statev, only: state_from_statev
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_replay_abaqus_host, only: host_point, new_host_point
   use asperity_replay_path_replay, only: path_step, replay_path
   use asperity_solid_contact_failed_point, only: failed_point, find_failed_point, keep_motions
   use asperity_solid_model_model, only: solid_model
   use asperity_solid_solve_programme, only: new_solid_run, run_programme, solid_run
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use joint_cases, only: joint_case, new_joint, stopper
   use test_petsc_engine, only: petsc
   implicit none
   private
   public :: suite_joint_failure

   procedure(uinter_interface) :: uinter

contains

   function suite_joint_failure() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('failure of the joint')
      call suite%addTest(TestMethod('UINTER follows the point', test_direct))
      call suite%addTest(TestMethod('and that of a joint through UINTER', test_through_uinter))
   end function suite_joint_failure

   subroutine test_direct()
      call check_failure(.false.)
   end subroutine test_direct

   subroutine test_through_uinter()
      call check_failure(.true.)
   end subroutine test_through_uinter

   !> In the second stroke, after the fit of the sides and 14 increments.
   subroutine check_failure(through_uinter)
      logical, intent(in) :: through_uinter
      type(joint_case) :: case
      type(solid_model) :: model
      type(solid_run) :: run
      type(stopper) :: watcher
      type(failed_point) :: failed
      type(host_point) :: point
      type(path_step), allocatable :: steps(:)
      type(contact_state) :: state
      type(error_type), allocatable :: error
      real(wp), parameter :: tolerance = 1.0e-12_wp
      integer :: n

      case = joint_case(amplitudes=[16.0_wp])
      case%settings%through_uinter = through_uinter
      call new_joint(model, case)
      call new_solid_run(run, model, petsc, error)
      call keep_motions(run%model%pairs)
      watcher%increments = 14
      call run_programme(run, watcher, error)
      call find_failed_point(run%model%pairs, failed, petsc%ranks)
      call assertEqual(0, failed%pair, 'stopped, nothing failed')
      run%model%settings%most_iterations = 4
      run%model%settings%forcing = 0.5_wp
      run%model%settings%tolerance = 1.0e-10_wp
      watcher%increments = huge(1)
      call run_programme(run, watcher, error)
      call assertTrue(allocated(error), 'it fails')
      call find_failed_point(run%model%pairs, failed, petsc%ranks)
      call assertTrue(failed%pair > 0, 'at a point')
      if (failed%pair == 0) return
      n = size(failed%path%time)
      call assertEqual(1 + run%increments + 1, n, 'undeformed, increments, what failed')
      call new_host_point(point, uinter, failed%properties, keep_history=.false.)
      call replay_path(failed%path, point, steps, error)
      call assertFalse(allocated(error), 'replayed')
      associate (cell => run%model%pairs(failed%pair)%faces(failed%face)%cells(failed%cell))
         call assertEqual(cell%trial%traction, steps(n)%traction, tolerance, 'what was tried')
         call state_from_statev(steps(n - 1)%statev, state)
         call assertTrue(maxval(steps(:n - 1)%traction(1)) > 0.1_wp, 'it was pressed')
         call assertEqual(cell%start%status, state%status, 'status')
         call assertEqual([cell%start%overclosure, cell%start%pressure, cell%start%elastic_slip, &
            cell%start%dissipation, cell%start%pressure_coupling], [state%overclosure, &
            state%pressure, state%elastic_slip, state%dissipation, state%pressure_coupling], &
            tolerance, 'the state of the last increment')
      end associate
   end subroutine check_failure

end module test_petsc_joint_failure
