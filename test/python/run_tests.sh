#!/usr/bin/env bash
# Test the Python package as a portable wheel, which install.sh makes:
#    run_tests.sh ENVIRONMENT FOLDER
set -eu
environment=$(realpath -m "$1")
"$(dirname "$0")/install.sh" "$1" "$2"
cd "$(dirname "$0")/../.."
PATH=$environment/bin:$PATH
unset LD_LIBRARY_PATH PYTHONPATH
(cd interface/python && mypy --cache-dir /dev/null asperity)
python -m pytest -p no:cacheprovider -o python_files='test_*.py check_wheel.py' test/python
