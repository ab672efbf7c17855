#!/usr/bin/env bash
# The comparison with other packages, of few points, with those that are installed: that it still runs,
# finds the same answers, and writes its page.
#
#   smoke_test.sh SOURCE_FOLDER LIBRARY [answer_benchmark]
set -euo pipefail
source=$1 library=$2 program=${3:-}

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for python in python3 /usr/bin/python3; do
  if "$python" -c 'import numpy, scipy' 2> /dev/null; then
    export BEESPACE_LIBRARY=$library PYTHONPATH=$source/python PYTHONDONTWRITEBYTECODE=1
    "$python" "$source/python/compare/compare.py" --smoke --runs 1 --memory --folder "$folder" \
      ${program:+--library "$program"}
    grep -q 'SciPy cKDTree' "$folder/python.md"
    grep -q '</svg>' "$folder/python/chart.svg"
    exit 0
  fi
done
echo "No Python here has NumPy and SciPy: scripts/install-packages test" >&2
exit 1
