#!/usr/bin/env bash
# Tests of CalculiX with UINTER: run_tests.sh CCX_STOCK CCX_UINTER ASPERITY
# CCX_STOCK is a ccx as it comes, CCX_UINTER what interface/calculix/build made; a third one, with
# the UINTER recorder.f90, is linked from the same folder, unless CCX_RECORDER names it. One line
# per check; the last line is `N passed, N failed`, or `skipped: reason` when there is no ccx, and
# the status is not zero when a check failed. Needs Python 3. KEEP=FOLDER keeps decks and results.
set -u
export LC_ALL=C
if [ $# -ne 3 ]; then
   echo "usage: run_tests.sh CCX_STOCK CCX_UINTER ASPERITY" >&2
   exit 2
fi
here=$(cd "$(dirname "$0")" && pwd)
skip() { echo "skipped: $1"; exit 0; }
stock=$(command -v "$1") || skip "there is no stock CalculiX '$1'"
uinter=$(command -v "$2") \
   || skip "there is no CalculiX with UINTER '$2'; interface/calculix/build makes it"
asperity=$(command -v "$3") || { echo "run_tests.sh: no program '$3'" >&2; exit 2; }
command -v python3 >/dev/null || skip 'there is no python3'
stock=$(realpath "$stock") uinter=$(realpath "$uinter") asperity=$(realpath "$asperity")

work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT
decks=$work/decks
if [ -n "${KEEP:-}" ]; then
   mkdir -p "$KEEP" || exit 3
   [ -z "$(ls -A "$KEEP")" ] || { echo "run_tests.sh: KEEP=$KEEP is not empty" >&2; exit 2; }
   decks=$(realpath "$KEEP")
fi
# Another UINTER in the folder of CCX_UINTER, by a path that scripts like to break on: source, program
folder="$work/a folder, o'clock \"new\"; \$(x)"
ln -s "$(dirname "$uinter")" "$folder" || exit 3
build() {
   "$here/../../../interface/calculix/build" --uinter "$here/uinter/$1" --folder "$folder" \
      --output "$2" >"$2.log" 2>&1 && return
   cat "$2.log"
   echo "FAIL ccx with test/calculix/ccx/uinter/$1 was not built"
   echo "0 passed, 1 failed"
   exit 1
}
recorder=${CCX_RECORDER:-} penalty=- events=-
if [ -z "$recorder" ]; then
   recorder=$work/ccx_recorder
   build recorder.f90 "$recorder"
   penalty=$work/ccx_penalty events=$work/ccx_events
   # fixed form, implicit types and an include, as user subroutines usually are
   build penalty.f "$penalty"
   build events.for "$events"
fi
PYTHONDONTWRITEBYTECODE=1 python3 "$here/run_checks.py" \
   "$stock" "$uinter" "$recorder" "$penalty" "$events" "$asperity" "$decks"
