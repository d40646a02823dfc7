#!/usr/bin/env bash
# `asperity surface` beside other programs: run_tests.sh ASPERITY FOLDER
# The Python packages of requirements.txt, in these versions, go into the Python environment
# FOLDER/../venv-surfaces, maps and the table differences.md into FOLDER; Gwyddion is compared where
# it and xvfb-run are installed. One line per check; the last line is `N passed, N failed`, or
# `skipped: reason` where those packages cannot be installed, and the status is not zero when a check
# failed. ASPERITY_NO_INSTALL=1 forbids to install them.
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
said=$(bash "$here/install.sh" "$venv") || skip "$said"
[ -z "$said" ] || echo "$said"
exec "$venv/bin/python" "$here/compare" "$asperity" "$folder" --table "$folder/differences.md"
