#!/usr/bin/env bash
# asperity solid on several ranks: run_tests.sh PROGRAM [PART...]
# A part is another script in this folder; without any, all of them. One line per test; the last line is
# `N passed, N failed`, and the status is not zero when a test failed, 77 where there is no mpirun or no
# PETSc.
set -u
export LC_ALL=C
if [ $# -lt 1 ] || [ ! -x "$1" ]; then
   echo "usage: run_tests.sh PROGRAM [PART...]" >&2
   exit 2
fi
program=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT
shift

. "$here/../program/harness.sh"
. "$here/ranks.sh"
cd "$work" || exit 3
command -v mpirun >/dev/null || { echo 'skipped: there is no mpirun'; exit 77; }
run solid --mesh-size 100 --contact rough --amplitudes 8
if grep -q 'PETSc is not installed' err; then
   echo 'skipped: PETSc is not installed'
   exit 77
fi
[ $# -gt 0 ] || set -- output histories resume faults interrupts
for part in "$@"; do
   echo "-- $part"
   mkdir "$work/$part" && cd "$work/$part" || exit 3
   . "$here/$part.sh"
done
[ "$skipped" -eq 0 ] || echo "$skipped skipped"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
