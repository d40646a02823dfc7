!> A build without PETSc has no solver.
submodule(asperity_solid_engine_linear_solver) without_petsc
   use asperity_base_error, only: fatal_error
   implicit none

contains

   module procedure start_engine
      call fatal_error(error, no_engine//', which the solid joint needs: install '// &
         'libpetsc-real-dev (Debian, Ubuntu) and build again with CMake')
   end procedure start_engine

   module procedure stop_engine
   end procedure stop_engine

   module procedure set_pattern
      self%n = size(row_start) - 1
      associate (unused => columns)
      end associate
      call start_engine(error)
   end procedure set_pattern

   module procedure factorise
      self%has_factors = .false.
      call start_engine(error)
   end procedure factorise

   module procedure solve
      self%has_factors = .false.
      solution = right_side
      call start_engine(error)
   end procedure solve

   module procedure iterate
      self%has_factors = .false.
      solution = right_side
      has_converged = tolerance > huge(1.0_wp)
      call start_engine(error)
   end procedure iterate

   module procedure release
      self%has_factors = .false.
   end procedure release

end submodule without_petsc
