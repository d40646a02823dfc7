! Two equations by the solver of solids, or what is said where there is no PETSc
program solid
   use asperity, only: error_type, wp
   use asperity_solid_engine_linear_solver, only: linear_solver
   use asperity_solid_engine_petsc, only: load_petsc, unload_petsc
   implicit none
   type(linear_solver) :: solver
   type(error_type), allocatable :: error
   real(wp) :: solution(2)

   call load_petsc(solver%petsc, error)
   if (allocated(error)) then
      if (index(error%message, 'PETSC') == 0 .and. index(error%message, 'PETSc') == 0) error stop 1
      print '(2a)', 'solid: ', error%message
      stop
   end if
   call solver%set_pattern([0, 2, 4], [0, 1, 0, 1], [0, 2], error)
   if (allocated(error)) error stop 2
   solver%values = [2.0_wp, 1.0_wp, 1.0_wp, 3.0_wp]
   call solver%factorise(error)
   if (allocated(error)) error stop 3
   call solver%solve([4.0_wp, 7.0_wp], solution, error)
   if (allocated(error)) error stop 4
   if (.not. all(abs(solution - [1.0_wp, 2.0_wp]) < 1.0e-12_wp)) error stop 5
   call solver%release()
   call unload_petsc(solver%petsc)
   print '(a)', 'solid: two equations solved'
end program solid
