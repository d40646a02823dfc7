#!/usr/bin/env bash
# gfortran 12.2: allocate (x, source=a(list)) begins x at 0 where list is a vector.
#
# A good guess: x begins at 1, as the bounds of SOURCE= are those of an expression that is no whole array
# (Fortran 2018, 9.7.1.2 and 16.9.109); flang 19.1.7 does so. Seen: a vector subscript, in any dimension,
# makes all lower bounds 0, so that x(1) is the second value; no warning from -Wall -Wextra, nothing from
# -fcheck=all before the last element is asked for. Sections a(2:) and expressions begin at 1.
source "$(dirname "$0")/lib/setup.sh"
version_is 12.2 gfortran --version
version_is 19.1.7 flang-new-19 --version
cat >bounds.f90 <<'FORTRAN'
program bounds
   implicit none
   integer :: table(2, 3), list(3)
   integer, allocatable :: chosen(:), columns(:, :), section(:), sums(:)

   table = reshape([1, 2, 3, 4, 5, 6], [2, 3])
   list = [3, 1, 2]
   allocate (chosen, source=table(1, list))
   allocate (columns, source=table(:, list))
   allocate (section, source=list(2:))
   allocate (sums, source=list + 1)
   print '(*(i0, :, 1x))', lbound(chosen), lbound(columns), lbound(section), &
      lbound(sums), chosen(1)
end program bounds
FORTRAN
seen=
for compiler in 'gfortran -std=f2018 -Wall -Wextra -Werror -fcheck=all' flang-new-19; do
   $compiler bounds.f90 -o bounds 2>log || { cat log; exit 1; }
   seen+="$(./bounds); "
done
expect '0 0 0 1 1 1; 1 1 1 1 1 5; ' "$seen"
