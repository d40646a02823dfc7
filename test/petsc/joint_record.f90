!> What is told of an increment: sums and largest values over the contact cells.
module test_petsc_joint_record
   use asperity, only: error_type, wp
   use asperity_solid_model_model, only: solid_model
   use asperity_solid_solve_programme, only: new_solid_run, solid_run
   use asperity_solid_solve_record, only: increment_record, new_record
   use test_petsc_engine, only: petsc
   use funit, only: assertEqual, TestMethod, TestSuite
   use joint_cases, only: joint_case, new_joint
   implicit none
   private
   public :: suite_joint_record

contains

   function suite_joint_record() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('records of the joint')
      call suite%addTest(TestMethod('pressure at a rim', test_rim))
   end function suite_joint_record

   !> One cell bears 3 MPa on all of its area, one 100 MPa on a hundredth, and one that is not
   !> covered bears nothing, whatever its gap.
   subroutine test_rim()
      type(joint_case) :: case
      type(solid_model) :: model
      type(solid_run) :: run
      type(increment_record) :: found
      type(error_type), allocatable :: error
      real(wp) :: areas(2), area

      case = joint_case('hard', amplitudes=[8.0_wp], side_pressure=0.0_wp)
      call new_joint(model, case)
      call new_solid_run(run, model, petsc, error)
      associate (cells => run%model%pairs(1)%faces(1)%cells)
         cells(1:3)%coverage = [1.0_wp, 0.01_wp, 0.0_wp]
         cells(1:3)%trial%traction(1) = [3.0_wp, 100.0_wp, 500.0_wp]
         areas = cells(1:2)%area
         area = sum(cells%area)
      end associate
      call new_record(found, run%model, run%displacement, run%ledger, 0, 1, 1, petsc%ranks)
      call assertEqual(100.0_wp, found%largest_pressure(1), tolerance=0.0_wp, message='largest')
      call assertEqual((3.0_wp*areas(1) + areas(2))/area, found%largest_mean_pressure, &
         tolerance=1.0e-12_wp, message='over the whole face')
      ! of both halves
      call assertEqual(2.0_wp*(3.0_wp*areas(1) + areas(2)), found%normal_force(1), &
         tolerance=1.0e-9_wp, message='force')
   end subroutine test_rim

end module test_petsc_joint_record
