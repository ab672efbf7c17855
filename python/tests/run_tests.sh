#!/usr/bin/env bash
# Runs the tests and the examples of the Python package with a library that is not installed.
#
#   run_tests.sh SOURCE_FOLDER LIBRARY [ARGUMENT OF PYTEST...]
#
# With BEESPACE_IO_LIBRARY, a libbeespace_io.so, reading files is tested, too; with BEESPACE_COMMAND
# against the command.
#
# It takes the first Python that has what the tests need; Debian's packages belong to Debian's Python,
# which need not be the first one. None is an error, or CI would test nothing.
set -euo pipefail
source=$1 library=$2
shift 2
documents=(../docs/python.md ../docs/python-prevention.md)
if [ -n "${BEESPACE_IO_LIBRARY:-}" ]; then documents+=(../docs/python-files.md); fi

for python in python3 /usr/bin/python3; do
  if "$python" -c 'import hypothesis, numpy, pytest, scipy' 2> /dev/null; then
    export BEESPACE_LIBRARY=$library PYTHONPATH=$source/python PYTHONDONTWRITEBYTECODE=1
    cd "$source/python"
    # Examples of beespace.spark need a cluster: scripts/test-spark.
    exec "$python" -m pytest -q -p no:cacheprovider --doctest-modules --ignore=beespace/spark \
      -W error --doctest-glob='*.md' "$@" beespace tests "${documents[@]}"
  fi
done
echo "No Python here has NumPy, SciPy, pytest and Hypothesis: scripts/install-packages test" >&2
exit 1
