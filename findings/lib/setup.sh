# What every finding needs: strict bash, a temporary folder that goes at the end, and pinned packages
# that are installed there. Sourced: `source "$(dirname "$0")/lib/setup.sh"`; `$folder` is then the folder.
set -euo pipefail
findings=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# Packages of Python; `$python` is then the interpreter that has them
python_packages() { # name==version...
   python3 -m venv "$folder/venv"
   python=$folder/venv/bin/python
   "$python" -m pip install --quiet --disable-pip-version-check "$@"
}

# A package of Debian, unpacked into $folder/debian; the shared libraries that it needs must be there
debian_package() { # name=version
   mkdir -p "$folder/debian"
   (cd "$folder/debian" && { apt-get download "$1" || { apt-get update && apt-get download "$1"; }; }) \
      >"$folder/debian.log" 2>&1 || { cat "$folder/debian.log"; exit 1; }
   dpkg -x "$folder"/debian/"${1%%=*}"_*.deb "$folder/debian"
}

# A version that must be the one that was seen
version_is() { # expected command...
   local expected=$1 found
   found=$("${@:2}" 2>&1 || true)
   [[ $found == *"$expected"* ]] || { echo "'$found' is not version $expected"; exit 1; }
}

# The end of a finding: the output must be what was seen
expect() { # expected-output found-output
   printf '%s\n' "$2"
   [[ $1 == "$2" ]] && { echo "$(basename "$0"): as found"; exit 0; }
   printf '%s: this has changed; it was\n%s\n' "$(basename "$0")" "$1"
   exit 1
}
