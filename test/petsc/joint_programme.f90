!> Programmes of the whole joint: energy, steps, symmetry, UINTER, failure, an independent code.
module test_petsc_joint_programme
   use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
   use asperity, only: computation_error, error_type, wp
   use asperity_contact_state, only: status_open
   use asperity_solid_model_equations, only: held
   use asperity_solid_model_model, only: solid_model
   use asperity_solid_solve_programme, only: new_solid_run, run_programme, solid_run
   use test_petsc_engine, only: petsc
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, assertTrue, TestMethod, &
      TestSuite
   use joint_cases, only: joint_case, new_joint, run_of, stopper
   use measurements, only: record
   implicit none
   private
   public :: suite_joint_programme

contains

   function suite_joint_programme() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('programme of the joint')
      call suite%addTest(TestMethod('energy balance falls with the increment', test_balance))
      call suite%addTest(TestMethod('forces do not depend on the increment', test_increments))
      call suite%addTest(TestMethod('down is up in a mirror', test_mirror))
      call suite%addTest(TestMethod('through UINTER', test_uinter))
      call suite%addTest(TestMethod('by multigrid', test_multigrid))
      call suite%addTest(TestMethod('no shear where faces are open', test_open))
      call suite%addTest(TestMethod('what cannot be solved', test_failure))
      call suite%addTest(TestMethod('a matrix that cannot be factorised', test_matrix))
      call suite%addTest(TestMethod('forces of a prototype', test_prototype))
   end function suite_joint_programme

   !> First order in the increment: half of it leaves half or less.
   subroutine test_balance()
      type(joint_case) :: case
      type(solid_run) :: run
      real(wp) :: left(3)
      integer :: i

      case = joint_case(amplitudes=[16.0_wp])
      case%settings%tolerance = 1.0e-6_wp
      do i = 1, 3
         case%settings%stroke_increments = 10*2**(i - 1)
         call run_of(run, case)
         associate (last => run%records(size(run%records)))
            left(i) = abs(last%balance)/last%work
         end associate
      end do
      call record('solid.joint.balance.10', left(1))
      call record('solid.joint.balance.20', left(2))
      call record('solid.joint.balance.40', left(3))
      ! on so coarse a mesh
      call assertLessThan(left(1), 0.03_wp, 'work that is not accounted for, 10 increments')
      call assertLessThan(left(2), 0.55_wp*left(1), '20 increments')
      call assertLessThan(left(3), 0.55_wp*left(2), '40 increments')
   end subroutine test_balance

   !> Ten increments a stroke or forty: peaks of the force differ by less than 0.5 %.
   subroutine test_increments()
      character(len=8), parameter :: contacts(2) = [character(len=8) :: 'rough', 'hard']
      type(joint_case) :: case
      type(solid_run) :: few, many
      integer :: i, j

      do i = 1, 2
         case = joint_case(contacts(i), amplitudes=[4.0_wp, 16.0_wp])
         call run_of(few, case)
         case%settings%stroke_increments = 40
         call run_of(many, case)
         do j = 2, size(few%model%turns)
            call assertEqual(force_at(many, j), force_at(few, j), &
               tolerance=0.005_wp*abs(force_at(many, j)), message='force at a turn')
         end do
      end do
   end subroutine test_increments

   !> Force where the load turns, N.
   real(wp) function force_at(run, turn) result(force)
      type(solid_run), intent(in) :: run
      integer, intent(in) :: turn
      integer :: i

      i = findloc(run%records%stroke, turn - 1, 1, back=.true.)
      force = run%records(i)%force
   end function force_at

   !> Clearances are equal, the column bears no load, and both its ends are held.
   subroutine test_mirror()
      type(joint_case) :: case
      type(solid_run) :: up, down
      integer :: i

      case = joint_case(side_pressure=0.0_wp, amplitudes=[16.0_wp])
      case%settings%tolerance = 1.0e-8_wp
      call begin(up)
      call begin(down)
      down%model%turns = -down%model%turns
      call go_on(up, stopper(strokes=1))
      call go_on(down, stopper(strokes=1))
      call assertEqual(size(up%records), size(down%records), message='increments')
      do i = 1, size(up%records)
         call assertEqual(up%records(i)%force, -down%records(i)%force, &
            tolerance=1.0e-6_wp*abs(up%records(i)%force), message='force')
      end do

   contains

      subroutine begin(run)
         type(solid_run), intent(out) :: run
         type(solid_model) :: model
         type(error_type), allocatable :: error
         integer :: gone

         call new_joint(model, case)
         associate (head => model%mesh%heads(1)%nodes)
            gone = model%numbers(3, head(1))
            model%numbers(3, head) = held
         end associate
         where (model%numbers > gone) model%numbers = model%numbers - 1
         model%n_unknowns = model%n_unknowns - 1
         model%column_loads = model%column_loads(:0)
         call new_solid_run(run, model, petsc, error)
      end subroutine begin

   end subroutine test_mirror

   !> Go on with a run that was stopped.
   subroutine go_on(run, until, error)
      type(solid_run), intent(inout) :: run
      type(stopper), intent(in) :: until
      type(error_type), allocatable, intent(out), optional :: error
      type(stopper) :: observer
      type(error_type), allocatable :: found

      observer = until
      call run_programme(run, observer, found)
      if (present(error)) call move_alloc(found, error)
   end subroutine go_on

   subroutine test_uinter()
      type(joint_case) :: case
      type(solid_run) :: direct, through
      real(wp) :: worst

      case = joint_case(amplitudes=[8.0_wp])
      call run_of(direct, case)
      case%settings%through_uinter = .true.
      call run_of(through, case)
      call assertEqual(direct%iterations, through%iterations, message='iterations')
      worst = maxval(abs(direct%records%force - through%records%force)) &
         /maxval(abs(direct%records%force))
      call record('solid.joint.uinter', worst)
      call assertLessThan(worst, 1.0e-12_wp, 'forces')
      call assertEqual(direct%records%friction, through%records%friction, &
         tolerance=1.0e-10_wp*maxval(direct%records%friction), message='friction')
   end subroutine test_uinter

   !> The same increments; forces as near as their tolerance lets them be.
   subroutine test_multigrid()
      type(joint_case) :: case
      type(solid_run) :: factors, multigrid
      real(wp) :: worst

      case = joint_case(amplitudes=[16.0_wp])
      call run_of(factors, case)
      case%settings%uses_multigrid = .true.
      call run_of(multigrid, case)
      call assertTrue(multigrid%system%solver%is_multigrid, 'no matrix was left to factors')
      call assertEqual(size(factors%records), size(multigrid%records), message='increments')
      worst = maxval(abs(factors%records%force - multigrid%records%force)) &
         /maxval(abs(factors%records%force))
      call record('solid.joint.multigrid', worst)
      call assertLessThan(worst, 10.0_wp*case%settings%tolerance, 'forces')
   end subroutine test_multigrid

   !> At every turn: open cells bear neither pressure nor shear, and remember no elastic slip.
   subroutine test_open()
      type(joint_case) :: case
      type(solid_run) :: run
      integer :: turn, i, j, n

      case = joint_case(amplitudes=[16.0_wp], side_pressure=0.0_wp)
      do turn = 1, 2
         call run_of(run, case, stopper(strokes=turn))
         n = 0
         do i = 1, size(run%model%pairs)
            do j = 1, size(run%model%pairs(i)%faces)
               associate (cells => run%model%pairs(i)%faces(j)%cells)
                  n = n + count(cells%start%status == status_open)
                  call assertTrue(all(cells%start%status /= status_open &
                     .or. (abs(cells%trial%traction(2)) + abs(cells%trial%traction(3)) &
                     + abs(cells%start%elastic_slip(1)) + abs(cells%start%elastic_slip(2)) &
                     <= 0.0_wp)), 'open')
               end associate
            end do
         end do
         call assertGreaterThan(n, 10, message='open cells')
      end do
   end subroutine test_open

   !> Four iterations that halve the residual do not reach 1e-10: the error names stroke and place,
   !> the run stands where it stood, and goes on from there when it may take more iterations.
   subroutine test_failure()
      type(joint_case) :: case
      type(solid_run) :: whole, run, kept
      type(error_type), allocatable :: error

      case = joint_case(amplitudes=[16.0_wp])
      call run_of(whole, case, stopper(strokes=2))
      call run_of(run, case, stopper(increments=14))
      kept = run
      run%model%settings%most_iterations = 4
      run%model%settings%forcing = 0.5_wp
      run%model%settings%tolerance = 1.0e-10_wp
      call go_on(run, stopper(strokes=2), error)
      call assertTrue(allocated(error), 'it fails')
      if (.not. allocated(error)) return
      call assertEqual(1, index(error%message, 'no increment is small enough in stroke 2 from '// &
         '16.0 to -16.0 mm, at 3.20000 mm: no equilibrium after 4 iterations'), &
         message=error%message)
      call assertTrue(is_same(run, kept), 'it stands where it stood')
      run%model%settings = kept%model%settings
      call go_on(run, stopper(strokes=2))
      call assertEqual(2, run%strokes_done)
      call assertEqual(-16.0_wp, run%displacement(3, run%model%mesh%load(1)), &
         tolerance=1.0e-9_wp)
      call assertEqual(force_at(whole, 3), force_at(run, 3), &
         tolerance=0.001_wp*abs(force_at(whole, 3)), message='force')
   end subroutine test_failure

   !> A matrix that cannot be factorised makes an increment shorter, and then the run fail.
   subroutine test_matrix()
      type(joint_case) :: case
      type(solid_run) :: run, kept
      type(error_type), allocatable :: error

      case = joint_case(amplitudes=[16.0_wp])
      call run_of(run, case, stopper(increments=4))
      kept = run
      run%model%shapes(1)%stiffness(1, 1) = ieee_value(1.0_wp, ieee_quiet_nan)
      call go_on(run, stopper(strokes=1), error)
      call assertTrue(allocated(error), 'it fails')
      if (.not. allocated(error)) return
      call assertEqual(computation_error, error%category)
      call assertEqual(1, index(error%message, 'no increment is small enough in stroke 1 from '// &
         '0.0 to 16.0 mm, at 6.40000 mm: the matrix has entries that are not numbers'), &
         message=error%message)
      call assertTrue(is_same(run, kept), 'it stands where it stood')
   end subroutine test_matrix

   !> Displacements, histories and records.
   logical function is_same(run, other)
      type(solid_run), intent(in) :: run, other
      integer :: i, j

      associate (strain => run%model%points%equivalent_strain, &
            other_strain => other%model%points%equivalent_strain)
         is_same = all(abs(run%displacement - other%displacement) <= 0.0_wp) &
            .and. size(run%records) == size(other%records) &
            .and. all(abs(strain - other_strain) <= 0.0_wp) &
            .and. abs(run%ledger%balance - other%ledger%balance) <= 0.0_wp
      end associate
      do i = 1, size(run%model%pairs)
         do j = 1, size(run%model%pairs(i)%faces)
            associate (a => run%model%pairs(i)%faces(j)%cells%start, &
                  b => other%model%pairs(i)%faces(j)%cells%start)
               is_same = is_same .and. all(a%status == b%status) &
                  .and. all(abs(a%pressure - b%pressure) <= 0.0_wp) &
                  .and. all(abs(a%dissipation - b%dissipation) <= 0.0_wp)
            end associate
         end do
      end do
   end function is_same

   !> Peaks at 8, 16 and 24 mm under Mises' criterion on the 60 mm mesh, by a prototype of the same
   !> equations, separate code, with three digits: 15.5, 23.8 and 26.7 kN.
   subroutine test_prototype()
      real(wp), parameter :: peaks(3) = [15.5e3_wp, 23.8e3_wp, 26.7e3_wp]
      type(joint_case) :: case
      type(solid_run) :: run
      integer :: i

      case = joint_case(criterion='mises', mesh_size=60.0_wp, side_pressure=0.2_wp, &
         column_load=54.0e3_wp, amplitudes=[8.0_wp, 16.0_wp, 24.0_wp])
      call run_of(run, case)
      do i = 1, 3
         call assertEqual(peaks(i), force_at(run, 2*i), tolerance=0.02_wp*peaks(i), message='peak')
      end do
   end subroutine test_prototype

end module test_petsc_joint_programme
