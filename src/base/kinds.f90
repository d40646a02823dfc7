!> The one real kind of the library.
module asperity_base_kinds
   use, intrinsic :: iso_c_binding, only: c_intptr_t
   use, intrinsic :: iso_fortran_env, only: real64
   implicit none
   private

   !> Working precision of every real number: IEEE double, whatever the compiler's default is.
   integer, parameter, public :: wp = real64
   !> 1. A compiler for 32 bits stops here, at a division by zero: UINTER and the C interface need
   !> addresses and doubles at multiples of 8 bytes
   integer, parameter, public :: asperity_needs_a_64_bit_system = 1/(storage_size( &
      0_c_intptr_t)/64)
end module asperity_base_kinds
