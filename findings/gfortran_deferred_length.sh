#!/usr/bin/env bash
# gfortran 12.2: the length of a function result of deferred length stands in static storage, even with
# -frecursive and -fopenmp.
#
# A good guess: local variables and results of a pure function belong to the call, so that threads may
# call it at once. Seen: where the result is passed on, its length is in a static variable slen.N of the
# caller, one for all threads.
source "$(dirname "$0")/lib/setup.sh"
version_is 12.2 gfortran --version
cat >lengths.f90 <<'F'
module lengths
   implicit none
contains
   pure function repeated(n) result(text)
      integer, intent(in) :: n
      character(len=:), allocatable :: text

      text = repeat('x', n)
   end function repeated

   pure subroutine count_them(n, found)
      integer, intent(in) :: n
      integer, intent(out) :: found

      found = len_trim('a'//repeated(n)//'b')
   end subroutine count_them
end module lengths
F
gfortran -c -O2 -frecursive -fopenmp lengths.f90
expect 'b slen' "$(nm lengths.o | awk '/slen/ { print $2, $3 }' | sed 's/slen.*/slen/' | sort -u)"
