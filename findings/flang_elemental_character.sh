#!/usr/bin/env bash
# flang 19.1.7 (Debian's flang-19): an elemental function of character(len=len(text)) leaves the end
# of each element unset when its argument is an array.
#
# A good guess: copies of 'abc', 'de' and 'f' of length 10 have blanks behind the letters, as with
# gfortran 12.2. Seen: characters 9 and 10 of each are what happened to be in memory, at every level
# of optimisation; the first eight are right.
source "$(dirname "$0")/lib/setup.sh"
version_is 19.1.7 flang-new-19 --version
cat >elemental.f90 <<'F'
program elemental
   implicit none
   character(len=10), parameter :: names(3) = [character(len=10) :: 'abc', 'de', 'f']

   call compare(names)
contains
   subroutine compare(list)
      character(len=*), intent(in) :: list(:)
      character(len=10) :: copies(3)

      copies = same(list)
      print '(2l2)', all(copies(:)(:8) == list(:)(:8)), all(copies == list)
   end subroutine compare

   elemental function same(text) result(copy)
      character(len=*), intent(in) :: text
      character(len=len(text)) :: copy

      copy = text
   end function same
end program elemental
F
found=
for options in 'gfortran -O0' 'gfortran -O2' 'flang-new-19 -O0' 'flang-new-19 -O1' 'flang-new-19 -O2'; do
   $options elemental.f90 -o elemental
   found+="$options$(./elemental); "
done
expect 'gfortran -O0 T T; gfortran -O2 T T; flang-new-19 -O0 T F; flang-new-19 -O1 T F; flang-new-19 -O2 T F; ' \
   "$found"
