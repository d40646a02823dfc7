#!/usr/bin/env bash
# gfortran 12.2: no loop can declare its own integer.
#
# A good guess: since Fortran 2008 a loop may declare its variable where it stands, do concurrent (integer ::
# i = 1:3), forall (integer :: i = 1:3) and the implied do [(i*i, integer :: i = 1, 3)], and -std=f2018 takes
# what that standard has. Seen: a syntax error at each; flang 19.1.7 takes all three. Where IMPLICIT NONE
# stands, a constant array by an implied do needs a variable that its module declares for nothing else.
source "$(dirname "$0")/lib/setup.sh"
version_is 12.2 gfortran --version
version_is 19.1.7 flang-new-19 --version
program() { # statements
   printf '%s\n' 'program squares' 'implicit none' 'integer :: n(3)' "$@" 'print *, sum(n)' 'end program squares'
}
program 'n = [(i*i, integer :: i = 1, 3)]' >implied.f90
program 'do concurrent (integer :: i = 1:3)' 'n(i) = i*i' 'end do' >concurrent.f90
program 'forall (integer :: i = 1:3) n(i) = i*i' >forall.f90
seen=
for compiler in 'gfortran -std=f2018' flang-new-19; do
   for name in implied concurrent forall; do
      $compiler $name.f90 -o $name >>log 2>&1 && seen+=" $name $(./$name | tr -d ' ')," || seen+=" $name refused,"
   done
done
expect 'implied refused, concurrent refused, forall refused, implied 14, concurrent 14, forall 14' "${seen:1:-1}"
