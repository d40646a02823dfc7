#!/usr/bin/env bash
# Black-box tests of the program: run_tests.sh PROGRAM [PART...]
# A part is a script in a folder beside this one, such as `curve`; without any, all of them. One line
# per test; the last line is `N passed, N failed`, and the status is not zero when a test
# failed. Needs a POSIX system, awk and, for some tests, gnuplot, python3 and a Fortran compiler
# ($FC, gfortran or flang); without these such tests are skipped, and say so.
set -u
export LC_ALL=C
if [ $# -lt 1 ] || [ ! -x "$1" ]; then
   echo "usage: run_tests.sh PROGRAM [PART...]" >&2
   exit 2
fi
program=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT
shift

. "$here/harness.sh"
[ $# -gt 0 ] || set -- $(cd "$here" && basename -s .sh ./*/*.sh)
for part in "$@"; do
   echo "-- $part"
   mkdir "$work/$part" && cd "$work/$part" || exit 3
   . "$here"/*/"$part.sh"
done
[ "$skipped" -eq 0 ] || echo "$skipped skipped"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
