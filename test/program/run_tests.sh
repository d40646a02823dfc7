#!/usr/bin/env bash
# Black-box tests of the program: run_tests.sh PROGRAM
# One line per test; the last line is `N passed, N failed`, and the status is not zero when a test
# failed. Needs a POSIX system, awk and, for some tests, gnuplot, python3 and a Fortran compiler
# ($FC, gfortran or flang); without these such tests are skipped, and say so.
set -u
export LC_ALL=C
if [ $# -ne 1 ] || [ ! -x "$1" ]; then
   echo "usage: run_tests.sh PROGRAM" >&2
   exit 2
fi
program=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 3

. "$here/harness.sh"
for part in input/options commands/{curve,press,shear,tenon,table,deck,hysteresis,records,surface} \
   input/{surface_files,case_file,bad_input} output/{output,writing,picture,looks}; do
   echo "-- $part"
   . "$here/$part.sh"
done
[ "$skipped" -eq 0 ] || echo "$skipped skipped"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
