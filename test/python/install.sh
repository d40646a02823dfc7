#!/usr/bin/env bash
# Make the wheel of the Python package, portable, in FOLDER/dist, and install it in an environment of its own:
#    install.sh ENVIRONMENT FOLDER
set -eu
environment=$(realpath -m "$1") folder=$(realpath -m "$2")
cd "$(dirname "$0")/../.."
[ -x "$environment/bin/python" ] || python3 -m venv "$environment"
PATH=$environment/bin:$PATH
export PIP_DISABLE_PIP_VERSION_CHECK=1
pip install --quiet --requirement test/python/requirements.txt
rm -rf "$folder"
pip wheel --quiet --no-deps --wheel-dir "$folder/built" interface/python
# nothing tells where libraries are but the system and, afterwards, the wheel
unset LD_LIBRARY_PATH
auditwheel repair --wheel-dir "$folder/dist" "$folder"/built/*.whl
pip install --quiet --force-reinstall --no-deps "$folder"/dist/*.whl
