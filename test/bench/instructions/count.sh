#!/usr/bin/env bash
# Count the instructions of a call of UINTER and of a node of VUINTER, by valgrind's callgrind, which
# unlike a clock does not drift:
#    count.sh BUILD [--profile]
# BUILD is a folder in which the target asperity_bench_O2_core was built, of this commit or of an older
# one. FC names the compiler that built it. --profile prints a table of where the instructions of
# UINTER's stick go, for docs/performance.md.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
build=${1:?folder of a build}
command -v valgrind >/dev/null || { echo 'count.sh: there is no valgrind' >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
"${FC:-gfortran}" -O2 -J "$work" -I "$build/modules/asperity_bench_O2_core" \
   "$here/../../support/abaqus_stubs.f90" "$here/../../abaqus/abaqus_utilities.f90" "$here/calls.f90" \
   "$build/libasperity_bench_O2_core.a" -o "$work/calls"

# Instructions that a run executes within a routine and what it calls, a point
count() { # routine what points
   valgrind --tool=callgrind --callgrind-out-file="$work/$2" --toggle-collect="$1_" \
      "$work/calls" "$2" "$3" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
   awk -v points="$3" '/^(summary|totals):/ { n = $2 } END { printf "%.0f\n", n/points }' "$work/$2"
}

stick=$(count uinter stick 2000)
if [[ ${2:-} == --profile ]]; then
   echo '| procedure | instructions a call |'
   echo '|---|---|'
   callgrind_annotate --threshold=100 "$work/stick" | awk -v points=2000 '
      /^ *[0-9,]+ \(.*\)  .*:/ && !/PROGRAM TOTALS/ {
         n = $1
         gsub(",", "", n)
         name = $0
         sub(/^[^:]*:/, "", name)
         sub(/ \[.*/, "", name)
         sub(/^__asperity_/, "", name)
         sub(/_MOD_/, ": ", name)
         sub(/@@.*|(\.(isra|constprop|part)\.[0-9]+)+$/, "", name)
         sum += n/points
         if (n/points >= 40) printf "| %s | %.0f |\n", name, n/points
         else rest += n/points
      }
      END { printf "| the rest | %.0f |\n| **sum** | **%.0f** |\n", rest, sum }'
else
   echo "UINTER, stick, h = 1..5 $stick"
   echo "UINTER, slip, h = 1..5 $(count uinter slip 2000)"
   echo "VUINTER, 100 points a call, h = 1..5 $(count vuinter nodes 100)"
   echo "VUINTER, 10000 points a call, h = 1..5 $(count vuinter nodes 10000)"
fi
