#!/usr/bin/env bash
# flang 19.1.7 (Debian's flang-19): maxval of numbers that are all NaN depends on the optimisation.
#
# A good guess: it is NaN, as with gfortran 12.2 at every level and with flang at -O0, so that
# maxval(abs(difference)) < tolerance fails in a test whose results are NaN. Seen: from -O1 on flang
# gives -huge, and the comparison is true. minval stays NaN.
source "$(dirname "$0")/lib/setup.sh"
version_is 19.1.7 flang-new-19 --version
cat >maximum.f90 <<'F'
program maximum
   use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
   implicit none
   real :: x(5)

   x = ieee_value(x, ieee_quiet_nan)
   call compare(x)
contains
   subroutine compare(difference)
      real, intent(in) :: difference(:)

      print '(l1)', maxval(abs(difference)) < 1.0e-6
   end subroutine compare
end program maximum
F
found=
for options in 'gfortran -O0' 'gfortran -O2' 'flang-new-19 -O0' 'flang-new-19 -O1' 'flang-new-19 -O2'; do
   $options maximum.f90 -o maximum
   found+="$options $(./maximum); "
done
expect 'gfortran -O0 F; gfortran -O2 F; flang-new-19 -O0 F; flang-new-19 -O1 T; flang-new-19 -O2 T; ' \
   "$found"
