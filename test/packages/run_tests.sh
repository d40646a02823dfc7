#!/usr/bin/env bash
# `asperity surface` beside other programs: run_tests.sh ASPERITY FOLDER
# surfalize, SurfaceTopography and tamaas, in the versions of requirements.txt, go into the Python
# environment FOLDER/../venv-surfaces, maps and the table differences.md into FOLDER. One line per
# check; the last line is `N passed, N failed`, or `skipped: reason` where those packages cannot be
# installed, and the status is not zero when a check failed. ASPERITY_NO_INSTALL=1 forbids to
# install them.
set -u
export LC_ALL=C.UTF-8 OMP_NUM_THREADS=${OMP_NUM_THREADS:-2} PYTHONDONTWRITEBYTECODE=1
if [ $# -ne 2 ]; then
   echo "usage: run_tests.sh ASPERITY FOLDER" >&2
   exit 2
fi
here=$(cd "$(dirname "$0")" && pwd)
skip() { echo "skipped: $1"; exit 0; }
asperity=$(command -v "$1") || { echo "run_tests.sh: no program '$1'" >&2; exit 2; }
asperity=$(realpath "$asperity")
mkdir -p "$2" || exit 3
folder=$(realpath "$2")
venv=$(dirname "$folder")/venv-surfaces
log=$folder/install.log

command -v python3 >/dev/null || skip 'there is no python3'
wanted=(--disable-pip-version-check --quiet --requirement "$here/requirements.txt")
if ! "$venv/bin/python" -m pip install --no-index "${wanted[@]}" >/dev/null 2>&1; then
   [ -z "${ASPERITY_NO_INSTALL:-}" ] \
      || skip "ASPERITY_NO_INSTALL is set; missing: $(paste -sd " " "$here/requirements.txt")"
   began=$SECONDS
   { python3 -m venv "$venv" && "$venv/bin/python" -m pip install "${wanted[@]}"; } \
      >"$log" 2>&1 || skip "the Python packages cannot be installed: $(tail -n 1 "$log")"
   echo "installed in $((SECONDS - began)) s: $(paste -sd ' ' "$here/requirements.txt")"
fi
exec "$venv/bin/python" "$here/compare" "$asperity" "$folder" --table "$folder/differences.md"
