#!/usr/bin/env bash
# Make the wheel of the Python package, portable, in FOLDER/dist, and test it in an environment of its own:
#    run_tests.sh ENVIRONMENT FOLDER
set -eu
cd "$(dirname "$0")/../.."
environment=$1 folder=$2
[ -x "$environment/bin/python" ] || python3 -m venv "$environment"
PATH=$(cd "$environment/bin" && pwd):$PATH
export PIP_DISABLE_PIP_VERSION_CHECK=1
# nothing but the wheel tells where libraries are
unset LD_LIBRARY_PATH PYTHONPATH
pip install --quiet --requirement test/python/requirements.txt
rm -rf "$folder"
pip wheel --quiet --no-deps --wheel-dir "$folder/built" interface/python
auditwheel repair --wheel-dir "$folder/dist" "$folder"/built/*.whl
pip install --quiet --force-reinstall --no-deps "$folder"/dist/*.whl
(cd interface/python && mypy --cache-dir /dev/null asperity)
python -m pytest -p no:cacheprovider -o python_files='test_*.py check_wheel.py' test/python
