!> One increment of a solid joint: Newton's method with the exact tangent. Factors of an earlier
!> matrix precondition GMRES until that is slow; the step is shortened where the residual grows.
module asperity_solid_solve_increment
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_solid_contact_pair, only: accept, begin_increment
   use asperity_solid_model_equations, only: moved
   use asperity_solid_model_model, only: solid_model
   use asperity_solid_solve_assembly, only: assemble
   use asperity_solid_solve_equations, only: equation_system, load_state
   use asperity_solid_solve_times, only: seconds_now
   implicit none
   private
   public :: increment_type, solve_increment

   !> What an increment is to do, and how it went.
   type :: increment_type
      !> Motion of the load, mm, and what else acts at its end
      real(wp) :: motion = 0.0_wp
      type(load_state) :: load
      !> Begin with the tangent, and not with the last increment's displacements, scaled
      logical :: is_fresh = .true.
      !> A joint that may be without contact, and so softly held that GMRES must leave next to
      !> nothing
      logical :: is_soft = .false.
      !> Iterations, and whether it was solved
      integer :: iterations = 0
      logical :: is_solved = .false.
      !> Why it was not
      character(len=:), allocatable :: reason
      !> Residual at its end over the scale of forces
      real(wp) :: residual = 0.0_wp
   end type increment_type

   !> Residual that GMRES leaves of a softly held joint: a larger one does not see that mode
   real(wp), parameter :: tight = 1.0e-8_wp
   !> A joint without contact drifts for long before it rests: so many times the iterations
   integer, parameter :: patience = 4
   !> Halvings of a step that does not reduce the residual
   integer, parameter :: most_halvings = 3
   !> A residual above the scale by this factor is not worth another iteration
   real(wp), parameter :: lost = 1.0e6_wp

contains

   !> Solve an increment. Displacements and histories are those of its end if it was solved,
   !> else those of its start. `error` is set when the engine fails.
   subroutine solve_increment(increment, model, system, displacement, before, last_motion, error)
      !> The increment
      type(increment_type), intent(inout) :: increment
      !> The joint
      type(solid_model), intent(inout) :: model
      !> Its equations
      type(equation_system), intent(inout) :: system
      !> Displacements at the start, then at the end; those at the start of the last increment, mm
      real(wp), intent(inout) :: displacement(:, :), before(:, :)
      !> Motion of the last increment, mm
      real(wp), intent(in) :: last_motion
      !> Set when the engine fails
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: start(3, size(displacement, 2))
      integer :: i

      start = displacement
      do i = 1, size(model%pairs)
         call begin_increment(model%pairs(i), model%mesh%nodes + displacement, error)
         if (allocated(error)) exit
      end do
      call system%solver%petsc%ranks%agree(error)
      if (allocated(error)) return
      increment%iterations = 0
      increment%is_solved = .false.
      if (allocated(increment%reason)) deallocate (increment%reason)
      if (.not. increment%is_fresh) displacement = displacement &
         + increment%motion/last_motion*(displacement - before)
      call iterate_to_equilibrium(increment, model, system, displacement, error)
      if (increment%is_solved) then
         before = start
         model%points = model%trial_points
         do i = 1, size(model%pairs)
            call accept(model%pairs(i))
         end do
      else
         displacement = start
      end if
   end subroutine solve_increment

   !> Newton's iterations, from a prediction.
   subroutine iterate_to_equilibrium(increment, model, system, displacement, error)
      type(increment_type), intent(inout) :: increment
      type(solid_model), intent(inout) :: model
      type(equation_system), intent(inout) :: system
      real(wp), intent(inout) :: displacement(:, :)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: step(model%n_unknowns), right_side(model%n_unknowns), residual, last_residual
      integer :: most_iterations
      logical :: is_prediction

      most_iterations = model%settings%most_iterations
      if (increment%is_soft) most_iterations = patience*most_iterations
      associate (settings => model%settings)
         is_prediction = increment%is_fresh
         last_residual = huge(1.0_wp)
         do
            call assemble(system, model, displacement, increment%load, .true., error)
            if (allocated(error)) return
            residual = norm2(system%residual)
            if (.not. is_usable(system)) then
               if (increment%iterations == 0 .or. is_prediction) then
                  increment%reason = 'the first guess turns elements inside out'
                  return
               end if
               residual = huge(1.0_wp)
            end if
            if (residual >= last_residual) then
               call shorten(residual)
               if (allocated(error)) return
               if (.not. is_usable(system)) then
                  increment%reason = 'elements turn inside out'
                  return
               end if
            end if
            increment%residual = residual/system%scale
            if (increment%iterations > 0 .and. &
               residual < max(settings%tolerance*system%scale, model%rounding)) then
               increment%is_solved = .true.
               return
            else if (.not. increment%residual < lost) then
               increment%reason = 'the residual is far above all forces'
               return
            else if (increment%iterations >= most_iterations) then
               increment%reason = 'no equilibrium after '//to_text(most_iterations)//' iterations'
               return
            end if
            right_side = -system%residual
            if (is_prediction) right_side = right_side - system%by_motion*increment%motion
            call solve_linear(step)
            if (allocated(error) .or. allocated(increment%reason)) return
            increment%iterations = increment%iterations + 1
            call move(step, merge(increment%motion, 0.0_wp, is_prediction))
            last_residual = merge(huge(1.0_wp), residual, is_prediction)
            is_prediction = .false.
         end do
      end associate

   contains

      !> The linear equations.
      subroutine solve_linear(solution)
         real(wp), intent(out) :: solution(:)
         real(wp) :: began, left
         logical :: has_converged

         left = merge(tight, model%settings%forcing, increment%is_soft)
         if (system%solver%has_factors) then
            began = seconds_now()
            call system%solver%iterate(right_side, solution, left, has_converged, error)
            system%times%solutions = system%times%solutions + seconds_now() - began
            if (allocated(error) .or. has_converged) return
         end if
         began = seconds_now()
         call system%solver%factorise(error)
         system%times%factors = system%times%factors + seconds_now() - began
         if (allocated(error)) then
            ! a shorter increment may have a better matrix
            increment%reason = error%message
            deallocate (error)
         else
            began = seconds_now()
            call system%solver%solve(right_side, solution, error, left)
            system%times%solutions = system%times%solutions + seconds_now() - began
         end if
      end subroutine solve_linear

      !> Add a step to the displacements.
      subroutine move(by, motion)
         real(wp), intent(in) :: by(:), motion
         integer :: i, j

         do j = 1, size(displacement, 2)
            do i = 1, 3
               if (model%numbers(i, j) > 0) then
                  displacement(i, j) = displacement(i, j) + by(model%numbers(i, j))
               else if (model%numbers(i, j) == moved) then
                  displacement(i, j) = displacement(i, j) + motion
               end if
            end do
         end do
      end subroutine move

      !> Halve the step until the residual falls; the best of the lengths tried stays.
      subroutine shorten(found)
         real(wp), intent(inout) :: found
         real(wp) :: length, best_length, best, tried
         integer :: k

         best = found
         best_length = 1.0_wp
         length = 1.0_wp
         do k = 1, most_halvings
            call move(-0.5_wp*length*step, 0.0_wp)
            length = 0.5_wp*length
            call assemble(system, model, displacement, increment%load, .false., error)
            if (allocated(error)) return
            if (.not. is_usable(system)) cycle
            tried = norm2(system%residual)
            if (tried < best) then
               best = tried
               best_length = length
            end if
            if (best < last_residual) exit
         end do
         call move((best_length - length)*step, 0.0_wp)
         call assemble(system, model, displacement, increment%load, .true., error)
         found = norm2(system%residual)
      end subroutine shorten

   end subroutine iterate_to_equilibrium

   !> Whether a state is one: no element inside out, and numbers everywhere.
   pure logical function is_usable(system)
      type(equation_system), intent(in) :: system

      is_usable = .not. system%is_inverted .and. all(abs(system%residual) <= huge(1.0_wp))
   end function is_usable

end module asperity_solid_solve_increment
