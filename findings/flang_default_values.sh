#!/usr/bin/env bash
# flang 19.1.7: default values of a derived type's components are set by a library call, a component at a time.
#
# A good guess: a variable of a type whose ten components have the default value zero is set as by an
# assignment, in some ten instructions; so it is by gfortran 12.2, and by flang where the ten are one component,
# an array or a type with a value as a whole. Seen, in instructions of a call at -O2 that has such a variable as
# intent(out): gfortran below 40, flang above 1000, and below 500 with the ten in a type of their own that is
# given a value as a whole. A procedure of a user who calls it for each point of a mesh may take ten times as long.
source "$(dirname "$0")/lib/setup.sh"
version_is 12.2 gfortran --version
version_is 19.1.7 flang-new-19 --version
version_is valgrind valgrind --version
ten='real(8) :: a = 0d0, b = 0d0, c = 0d0, d = 0d0, e = 0d0, f = 0d0, g = 0d0, h = 0d0, i = 0d0, j = 0d0'
types() { # components
   cat <<F
module types
   implicit none
   type :: ten
      $ten
   end type ten
   type :: values
      $1
   end type values
contains
   subroutine fresh(v)
      type(values), intent(out) :: v
   end subroutine fresh
end module types
F
}
cat >calls.f90 <<'F'
program calls
   use types, only: fresh, values
   implicit none
   type(values) :: v
   integer :: k
   do k = 1, 100
      call fresh(v)
   end do
end program calls
F
types "$ten" >apart.f90
types 'type(ten) :: all = ten()' >whole.f90
# Two files, so that nothing is taken into the loop
count() { # compiler source: instructions of a call
   "$1" -O2 -c "$2.f90" && "$1" -O2 calls.f90 "$2.o" -o "$2" 2>>log
   valgrind --tool=callgrind --callgrind-out-file=out --toggle-collect='*fresh*' "./$2" >>log 2>&1
   awk '/^(summary|totals):/ { n = $2 } END { printf "%d\n", n/100 }' out
}
g=$(count gfortran apart) f=$(count flang-new-19 apart) w=$(count flang-new-19 whole)
echo "gfortran $g, flang $f, flang as a whole $w"
expect 'few, many, fewer' "$( ((g < 40)) && echo -n few, ) $( ((f > 1000)) && echo -n many, ) $( ((w < 500)) && echo -n fewer)"
