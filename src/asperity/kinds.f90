!> The one real kind of the library.
module asperity_kinds
   use, intrinsic :: iso_fortran_env, only: real64
   implicit none
   private

   !> Working precision of every real number: IEEE double, whatever the compiler's default is.
   integer, parameter, public :: wp = real64
end module asperity_kinds
