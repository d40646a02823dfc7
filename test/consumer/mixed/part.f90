! What the C program calls
module part
   use, intrinsic :: iso_c_binding, only: c_double
   use asperity, only: equivalent_modulus
   implicit none
   private
   public :: modulus_of_two

contains

   ! Equivalent modulus of two equal bodies
   function modulus_of_two(modulus, poisson) bind(c) result(both)
      real(c_double), value, intent(in) :: modulus, poisson
      real(c_double) :: both

      both = equivalent_modulus(modulus, poisson, modulus, poisson)
   end function modulus_of_two

end module part
