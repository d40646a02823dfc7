!> Residual and matrix of the whole joint: derivative, rigid rotation, Newton's convergence, and
!> equilibria that do not depend on the first guess.
module test_petsc_joint_equations
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: error_type, wp
   use asperity_solid_contact_pair, only: begin_increment
   use asperity_solid_model_model, only: solid_model
   use asperity_solid_solve_assembly, only: assemble
   use asperity_solid_solve_equations, only: equation_system, load_state
   use asperity_solid_solve_increment, only: increment_type, solve_increment
   use asperity_solid_solve_programme, only: new_solid_run, solid_run
   use test_petsc_engine, only: petsc
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, assertTrue, &
      TestMethod, TestSuite
   use joint_cases, only: add_motion, add_unknowns, joint_case, new_joint, run_of, stopper
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_joint_equations

   integer(int64), parameter :: seed = 17320508_int64

contains

   function suite_joint_equations() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('equations of the joint')
      call suite%addTest(TestMethod('matrix against differences', test_tangent))
      call suite%addTest(TestMethod('a rigid rotation gives no force', test_rotation))
      call suite%addTest(TestMethod('quadratic convergence', test_convergence))
      call suite%addTest(TestMethod('50 first guesses, one equilibrium', test_guesses))
   end function suite_joint_equations

   !> In random states about one on the way to 16 mm, along random directions and that of the load.
   subroutine test_tangent()
      character(len=8), parameter :: contacts(2) = [character(len=8) :: 'rough', 'hard']
      character(len=8), parameter :: criteria(4) = [character(len=8) :: 'none', 'mises', 'hill', &
         'crushing']
      type(random_stream) :: stream
      integer :: i, j

      stream = random_stream(seed)
      write (*, '(5x, a, i0)') 'seed ', seed
      do i = 1, size(contacts)
         do j = 1, size(criteria)
            call compare(joint_case(contacts(i), criteria(j), amplitudes=[16.0_wp]), stream)
         end do
      end do
   end subroutine test_tangent

   subroutine compare(case, stream)
      type(joint_case), intent(in) :: case
      type(random_stream), intent(inout) :: stream
      !> Differences over the best of these: larger steps meet points that begin to yield or slip,
      !> smaller ones round-off
      real(wp), parameter :: steps(4) = [3.2e-5_wp, 8.0e-6_wp, 4.0e-6_wp, 2.0e-6_wp]
      integer, parameter :: directions = 4
      type(solid_run) :: run
      type(load_state) :: load
      type(error_type), allocatable :: error
      real(wp), allocatable :: low(:), high(:), along(:), direction(:), place(:, :)
      real(wp) :: best, worst
      integer :: i, k

      call run_of(run, case, stopper(increments=7))
      load = load_state(1.0_wp, 1.0_wp)
      do i = 1, size(run%model%pairs)
         call begin_increment(run%model%pairs(i), run%model%mesh%nodes + run%displacement, error)
      end do
      associate (n => run%model%n_unknowns)
         allocate (low(n), high(n), along(n), direction(n))
      end associate
      call draw(direction, 0.01_wp)
      allocate (place, source=run%displacement)
      call add_unknowns(run%model, place, direction)
      call add_motion(run%model, place, 1.0_wp)
      call assemble(run%system, run%model, place, load, .true., error)
      call assertFalse(allocated(error))
      if (case%criterion /= 'none') &
         call assertGreaterThan(run%system%n_yielding, 10, message='points that yield')
      worst = 0.0_wp
      do k = 0, directions
         call draw(direction, 1.0_wp)
         ! the first one is the motion of the load
         if (k == 0) then
            along = run%system%by_motion
         else
            along = product_of(run, direction)
         end if
         best = huge(1.0_wp)
         do i = 1, size(steps)
            low = residual_at(-steps(i))
            high = residual_at(steps(i))
            best = min(best, norm2((high - low)/(2.0_wp*steps(i)) - along)/norm2(along))
         end do
         worst = max(worst, best)
      end do
      call record('solid.joint.tangent.'//trim(case%contact)//'_'//case%criterion, worst)
      call assertLessThan(worst, 1.0e-7_wp, trim(case%contact)//' '//case%criterion)
      call run%system%solver%release()

   contains

      function residual_at(length) result(residual)
         real(wp), intent(in) :: length
         real(wp) :: residual(run%model%n_unknowns), there(3, size(place, 2))

         there = place
         if (k == 0) then
            call add_motion(run%model, there, length)
         else
            call add_unknowns(run%model, there, length*direction)
         end if
         call assemble(run%system, run%model, there, load, .false., error)
         residual = run%system%residual
      end function residual_at

      subroutine draw(vector, size_of)
         real(wp), intent(out) :: vector(:)
         real(wp), intent(in) :: size_of
         integer :: j

         do j = 1, size(vector)
            vector(j) = stream%uniform(-size_of, size_of)
         end do
      end subroutine draw

   end subroutine compare

   !> The matrix times a vector.
   function product_of(run, vector) result(product)
      type(solid_run), intent(in) :: run
      real(wp), intent(in) :: vector(:)
      real(wp) :: product(size(vector))
      integer :: i, k

      product = 0.0_wp
      associate (a => run%system%solver)
         do i = 1, a%n
            do k = a%row_start(i) + 1, a%row_start(i + 1)
               product(i) = product(i) + a%values(k)*vector(a%columns(k) + 1)
            end do
         end do
      end associate
   end function product_of

   !> Column and beam, turned together by half a radian, without springs and load. Forces are
   !> measured by those of a stretch by a hundredth of a per cent.
   subroutine test_rotation()
      real(wp), parameter :: c = cos(0.5_wp), s = sin(0.5_wp), stretch = 1.0e-4_wp
      real(wp), parameter :: turn(3, 3) = reshape([c, s, 0.0_wp, -s, c, 0.0_wp, 0.0_wp, 0.0_wp, &
         1.0_wp], [3, 3])
      type(joint_case) :: case
      type(solid_run) :: run
      type(solid_model) :: model
      type(error_type), allocatable :: error
      real(wp) :: scale
      integer :: k

      case = joint_case(side_pressure=0.0_wp, amplitudes=[16.0_wp])
      do k = 1, 3
         call new_joint(model, case)
         model%springs%stiffness = 0.0_wp
         call new_solid_run(run, model, petsc, error)
         associate (x => model%mesh%nodes)
            scale = largest(stretch*x)
            call assertGreaterThan(scale, 100.0_wp, 'a stretch does')
            call assertLessThan(largest(cshift(matmul(turn, cshift(x, k, 1)), -k, 1) - x), &
               1.0e-9_wp*scale, 'forces')
         end associate
      end do

   contains

      real(wp) function largest(displacement)
         real(wp), intent(in) :: displacement(:, :)
         type(error_type), allocatable :: error
         integer :: i

         do i = 1, size(run%model%pairs)
            call begin_increment(run%model%pairs(i), run%model%mesh%nodes + displacement, error)
         end do
         call assemble(run%system, run%model, displacement, load_state(), .false., error)
         largest = maxval(abs(run%system%residual))
      end function largest

   end subroutine test_rotation

   !> Newton's method from beside an equilibrium under plastic load: once near, each residual is
   !> below three times the square of the one before, and five steps reach round-off.
   subroutine test_convergence()
      type(joint_case) :: case
      type(solid_run) :: run, at_start
      type(random_stream) :: stream
      type(error_type), allocatable :: error
      real(wp), allocatable :: step(:)
      real(wp) :: residuals(0:5)
      integer :: i

      case = joint_case(amplitudes=[16.0_wp])
      case%settings%tolerance = 1.0e-8_wp
      case%settings%forcing = 1.0e-10_wp
      call run_of(at_start, case, stopper(increments=7))
      call run_of(run, case, stopper(increments=8))
      ! both are solved alike, so that the one's end is the solution of what follows the other's
      at_start%before = run%displacement
      allocate (step(run%model%n_unknowns))
      stream = random_stream(seed)
      do i = 1, size(step)
         step(i) = stream%uniform(-0.005_wp, 0.005_wp)
      end do
      call add_unknowns(run%model, at_start%before, step)
      do i = 1, size(at_start%model%pairs)
         call begin_increment(at_start%model%pairs(i), at_start%model%mesh%nodes &
            + at_start%displacement, error)
      end do
      do i = 0, ubound(residuals, 1)
         call assemble(at_start%system, at_start%model, at_start%before, &
            load_state(1.0_wp, 1.0_wp), .true., error)
         residuals(i) = norm2(at_start%system%residual)/at_start%system%scale
         call at_start%system%solver%factorise(error)
         call at_start%system%solver%solve(-at_start%system%residual, step, error)
         call assertFalse(allocated(error))
         call add_unknowns(run%model, at_start%before, step)
      end do
      write (*, '(5x, a, 6es9.1)') 'residuals', residuals
      call assertGreaterThan(residuals(0), 0.1_wp, 'it begins far away')
      call assertLessThan(residuals(3), 3.0_wp*residuals(2)**2, 'third step')
      call assertLessThan(residuals(5), 1.0e-11_wp, 'it ends at round-off')
      call assertLessThan(maxval(abs(at_start%before - run%displacement)), 1.0e-7_wp, &
         'at the same place')
      call at_start%system%solver%release()
   end subroutine test_convergence

   !> An increment into yield and slip from 50 first guesses within 0.02 mm of the
   !> usual one.
   subroutine test_guesses()
      integer, parameter :: n = 50
      type(joint_case) :: case
      type(solid_run) :: run
      type(solid_model) :: model
      type(random_stream) :: stream
      real(wp), allocatable :: guess(:)
      real(wp) :: forces(n)
      integer :: i, j

      stream = random_stream(seed + 1)
      write (*, '(5x, a, i0)') 'seed ', seed + 1
      case = joint_case(amplitudes=[16.0_wp])
      case%settings%tolerance = 1.0e-8_wp
      call run_of(run, case, stopper(increments=7))
      allocate (guess(run%model%n_unknowns))
      do i = 1, n
         model = run%model
         do j = 1, size(guess)
            guess(j) = stream%uniform(-0.02_wp, 0.02_wp)
         end do
         if (i == 1) guess = 0.0_wp
         forces(i) = force_from(run, model, guess)
      end do
      call record('solid.joint.guesses', (maxval(forces) - minval(forces))/maxval(abs(forces)))
      call assertEqual(forces(1), forces, tolerance=1.0e-4_wp*abs(forces(1)), message='forces')
   end subroutine test_guesses

   !> Force of the increment of 1.6 mm that follows a run, from a guess beside its extrapolation.
   real(wp) function force_from(run, model, guess) result(force)
      type(solid_run), intent(in) :: run
      type(solid_model), intent(inout) :: model
      real(wp), intent(in) :: guess(:)
      type(increment_type) :: increment
      type(equation_system) :: system
      type(error_type), allocatable :: error
      real(wp), allocatable :: displacement(:, :), before(:, :)

      system%solver%petsc = petsc
      allocate (system%residual(model%n_unknowns), system%by_motion(model%n_unknowns))
      allocate (displacement, source=run%displacement)
      allocate (before, source=run%before)
      ! what is extrapolated is the guess
      call add_unknowns(model, before, -guess)
      increment = increment_type(motion=1.6_wp, load=load_state(1.0_wp, 1.0_wp), is_fresh=.false.)
      call solve_increment(increment, model, system, displacement, before, 1.6_wp, error)
      call assertFalse(allocated(error))
      call assertTrue(increment%is_solved, 'solved')
      force = system%load_force
      call system%solver%release()
   end function force_from

end module test_petsc_joint_equations
