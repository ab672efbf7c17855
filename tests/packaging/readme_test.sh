#!/usr/bin/env bash
# Proves that the library example in the README is the one that is compiled, and that it prints
# what the README says.
#
#   readme_test.sh SOURCE_FOLDER QUICKSTART_PROGRAM
set -euo pipefail
source=$1 program=$2

# The code block that follows the line "<!-- NAME -->" in the README, without its fences.
block() {
  awk -v marker="<!-- $1 -->" '
    $0 == marker {found = 1; next}
    found && /^```/ {if (inside) exit; inside = 1; next}
    inside {print}
  ' "$source/README.md"
}

# Files, not <(...): a bare chroot has no /dev/fd.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
block examples/quickstart.cpp > "$scratch/example"
block "output of quickstart" > "$scratch/output"
"$program" > "$scratch/printed"

[ -s "$scratch/example" ] || { echo "README.md shows no example" >&2; exit 1; }
diff "$scratch/example" "$source/examples/quickstart.cpp" ||
  { echo "README.md and examples/quickstart.cpp differ, see above" >&2; exit 1; }
diff "$scratch/output" "$scratch/printed" ||
  { echo "the example prints something else than README.md says, see above" >&2; exit 1; }
