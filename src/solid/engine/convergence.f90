!> When GMRES is to stop.
module asperity_solid_engine_convergence
   use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_ptr
   use asperity_base_kinds, only: wp
   use asperity_solid_engine_petsc, only: ksp_converged_iterating, ksp_converged_rtol, &
      ksp_diverged_its
   implicit none
   private
   public :: convergence_context, residual_is_small

   !> Share of the residual with which GMRES gives up after its trial, if more is left
   real(wp), parameter :: hopeless = 0.3_wp

   !> What the test is told: the residual that may be left, over the first, which it keeps.
   type, bind(c) :: convergence_context
      !> Over the first
      real(c_double) :: tolerance
      !> Residual before the first vector
      real(c_double) :: first
      !> Most vectors, and of the trial
      integer(c_int) :: most, trial
      !> Vectors so far
      integer(c_int) :: vectors
   end type convergence_context

contains

   !> PETSc's convergence test: the tolerance, and no more vectors where the first were no use.
   integer(c_int) function residual_is_small(krylov, iteration, residual, reason, context) bind(c)
      !> PETSc's solver; number of the iteration, from 0; residual that is left
      type(c_ptr), value :: krylov, context
      integer(c_int), value :: iteration
      real(c_double), value :: residual
      !> Whether to stop, and why
      integer(c_int), intent(out) :: reason
      type(convergence_context), pointer :: asked

      residual_is_small = 0
      if (.not. c_associated(krylov)) residual_is_small = 1
      call c_f_pointer(context, asked)
      if (iteration == 0) asked%first = residual
      asked%vectors = iteration
      reason = ksp_converged_iterating
      if (residual <= asked%tolerance*asked%first) then
         reason = ksp_converged_rtol
      else if (iteration >= asked%most .or. .not. residual <= huge(1.0_wp)) then
         reason = ksp_diverged_its
      else if (iteration == asked%trial .and. residual > hopeless*asked%first) then
         reason = ksp_diverged_its
      end if
   end function residual_is_small

end module asperity_solid_engine_convergence
