#!/usr/bin/env bash
# Proves that scripts/check-includes lets good trees pass and names file, line and rule in bad ones.
#
#   check_includes_test.sh SOURCE_FOLDER
set -euo pipefail
source=$1
trees=$(mktemp -d)
trap 'rm -rf "$trees"' EXIT

fail() {
  echo "check_includes_test: $*" >&2
  printf '%s\n' "output: ${output:-}" >&2
  exit 1
}

tree() { # a new tree; further arguments: FILE LINE...
  root=$(mktemp -d "$trees/XXXX")
  local file=$1
  shift
  mkdir -p "$root/$(dirname "$file")"
  printf '%s\n' "$@" > "$root/$file"
}

passes() {
  tree "$@"
  output=$("$source/scripts/check-includes" "$root" 2>&1) || fail "refused: $*"
}

refuses() { # the text expected, then FILE LINE...
  local expected=$1
  shift
  tree "$@"
  if output=$("$source/scripts/check-includes" "$root" 2>&1); then fail "accepted: $*"; fi
  [[ "$output" == *"$expected"* ]] || fail "did not say '$expected' for: $*"
}

passes include/beespace/a.hpp '#include <beespace/b.hpp>' '#include <vector>'
passes src/core/a.cpp '#include "core/a.hpp"' '#include <beespace/point.hpp>' '#include <cmath>'
passes src/search/a.cpp '#include "core/a.hpp"' '#include "cpu/b.hpp"'
passes src/cpu/a.cpp '#include "core/a.hpp"' '#include <immintrin.h>'
passes io/a.cpp '#include "io/a.hpp"' '#include <zlib.h>' '#include <sys/mman.h>'
passes cli/a.cpp '#include "io/a.hpp"' '#include "scenes/b.hpp"' '#include <CLI/CLI.hpp>'
passes tests/core/a.cpp '#include "core/a.hpp"' '#include <gtest/gtest.h>'

refuses 'include/beespace/a.hpp:2: include/beespace may not know src/core' \
  include/beespace/a.hpp '#include <vector>' '#include "core/grid.hpp"'
refuses 'include/beespace may not know libraries' include/beespace/a.hpp '#include <zlib.h>'
refuses 'src/core/a.cpp:3: src/core may not know src/cpu' \
  src/core/a.cpp '#include <vector>' '' '#  include "cpu/threads.hpp"'
refuses 'src/core may not know src/search' src/core/a.hpp '#include "search/find_at_risk.hpp"'
refuses 'src/core may not know processor intrinsics' src/core/a.cpp '#include <immintrin.h>'
refuses 'src/search may not know the system' src/search/a.cpp '#include <sys/mman.h>'
refuses 'src/geodesy may not know src/core' src/geodesy/a.cpp '#include "core/a.hpp"'
refuses 'src/cpu may not know src/search' src/cpu/a.cpp '#include "search/a.hpp"'
refuses 'cli may not know src/core' cli/a.cpp '#include "exact/exact_distance.hpp"'
refuses 'cli may not know src/core' cli/a.cpp '#include "src/exact/exact_distance.hpp"'
refuses 'io may not know scenes' io/a.cpp '#include "scenes/a.hpp"'
refuses 'scenes may not know io' scenes/a.cpp '#include "io/a.hpp"'
refuses 'examples may not know io' examples/a.cpp '#include "io/a.hpp"'
refuses 'write the room too' src/core/a.cpp '#include "a.hpp"'
refuses 'write the room too' src/core/a.cpp '#include "../cpu/a.hpp"'
refuses 'in angle brackets' cli/a.cpp '#include "beespace/point.hpp"'
refuses 'this folder has no rule' new_room/a.cpp '#include <vector>'
refuses 'no C++ files' README.md 'nothing to check is not a success'
