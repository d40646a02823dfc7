!> PETSc for all tests of this folder: a process can start it once.
module test_ranks_engine
   use asperity_solid_engine_petsc, only: petsc_library
   implicit none
   private

   !> Set by the main program
   type(petsc_library), public :: petsc
end module test_ranks_engine
