#!/usr/bin/env bash
# Whether interface/abaqus/ready is what its sources give, and every compiler can take it: ready.sh
set -u -o pipefail
export LC_ALL=C
cd "$(dirname "$0")/../.." || exit 3
ready=interface/abaqus/ready
fresh=$(mktemp -d) || exit 3
trap 'rm -rf "$fresh"' EXIT
passed=0
failed=0

check() { # what-is-wrong command...
   if "${@:2}"; then ((passed += 1)); else
      ((failed += 1))
      echo "FAIL $1"
   fi
}

nothing_printed() { [[ -z $("$@" | tee /dev/stderr) ]]; }

is_python() { # file: with the names that ABAQUS' own settings give
   python3 -c 'import sys
names = {"compile_fortran": ["ifort", "-c", "%P"], "link_sl": []}
exec(open(sys.argv[1]).read(), names)
for name in "compile_fortran", "link_sl":
   assert all(isinstance(word, str) and " " not in word for word in names[name]), name
assert names["compile_fortran"].count("%P") == 1' "$1"
}

cmake -D output="$fresh" -P cmake/abaqus.cmake >/dev/null || exit
check "$ready is not what its sources give: ./run abaqus ready renews it" diff -r -q "$ready" "$fresh"
for file in "$ready"/asperity_*; do
   check "$file has a character that is not ASCII" nothing_printed grep -n '[^ -~]' "$file"
   check "$file has a line of more than 100 columns" nothing_printed awk 'length > 100' "$file"
done
for file in "$ready"/environment/*.env; do
   check "$file is not what ABAQUS reads" is_python "$file"
done
echo "$passed passed, $failed failed"
((failed == 0))
