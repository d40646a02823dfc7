#!/usr/bin/env bash
# Put the packages of requirements.txt into the Python environment VENV, unless they are there:
#    install.sh VENV
# A reason is printed, and the status is 1, when they cannot be. ASPERITY_NO_INSTALL=1 forbids it.
set -u
here=$(cd "$(dirname "$0")" && pwd)
venv=$1
wanted=(--disable-pip-version-check --quiet --requirement "$here/requirements.txt")
names=$(paste -sd ' ' "$here/requirements.txt")
refuse() { echo "$1"; exit 1; }

command -v python3 >/dev/null || refuse 'there is no python3'
"$venv/bin/python" -m pip install --no-index "${wanted[@]}" >/dev/null 2>&1 && exit
[ -z "${ASPERITY_NO_INSTALL:-}" ] || refuse "ASPERITY_NO_INSTALL is set; missing: $names"
began=$SECONDS
said=$({ python3 -m venv "$venv" && "$venv/bin/python" -m pip install "${wanted[@]}"; } 2>&1) \
   || refuse "the Python packages cannot be installed: $(tail -n 1 <<<"$said")"
echo "installed in $((SECONDS - began)) s: $names"
