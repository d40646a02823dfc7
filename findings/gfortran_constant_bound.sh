#!/usr/bin/env bash
# gfortran 12.2: the upper bound of a constant array is wrong in the bounds of an automatic one.
#
# A good guess: where ends is a constant with bounds 0 to 3, real :: x(ubound(ends, 1)) has 3 elements, as
# ubound(ends, 1) is 3. Seen: x has 4, as if ends began at 1; in a statement ubound(ends, 1) is 3. flang 19.1.7
# gives 3 and 3. Name the bound, and use its name in both places.
source "$(dirname "$0")/lib/setup.sh"
version_is 12.2 gfortran --version
version_is 19.1.7 flang-new-19 --version
cat >bound.f90 <<'F90'
module constant
   implicit none
   real, parameter :: ends(0:3) = [0.0, 2.0, -2.0, 0.0]
contains
   subroutine show()
      real :: x(ubound(ends, 1))
      print '(i0, a, i0)', size(x), ' ', ubound(ends, 1)
   end subroutine show
end module constant
program main
   use constant, only: show
   implicit none
   call show()
end program main
F90
gfortran bound.f90 -o gnu && flang-new-19 bound.f90 -o llvm
expect '4 3, 3 3' "$(./gnu), $(./llvm)"
