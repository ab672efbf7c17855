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
passes src/exact/a.cpp '#include "exact/a.hpp"' '#include <beespace/point.hpp>' '#include <cmath>'
passes src/search/a.cpp '#include "exact/a.hpp"' '#include "kernels/b.hpp"'
passes src/kernels/a.cpp '#include "exact/a.hpp"' '#include <immintrin.h>'
passes src/motion/live/a.cpp '#include "motion/passing/a.hpp"'
passes io/a.cpp '#include "io/bytes/a.hpp"' '#include <zlib.h>'
passes io/bytes/a.cpp '#include <sys/mman.h>'
passes analysis/scene/a.cpp '#include "analysis/recorded/a.hpp"' '#include "report/facts.hpp"'
passes cli/command_line/a.cpp '#include "cli/console/a.hpp"' '#include <CLI/CLI.hpp>'
passes cli/watch/a.cpp '#include "io/live/a.hpp"' '#include "analysis/live/b.hpp"'
passes tests/grid/a.cpp '#include "grid/a.hpp"' '#include <gtest/gtest.h>'

refuses 'include/beespace/a.hpp:2: include/beespace may not know src/grid' \
  include/beespace/a.hpp '#include <vector>' '#include "grid/lattice.hpp"'
refuses 'include/beespace may not know libraries' include/beespace/a.hpp '#include <zlib.h>'
refuses 'src/exact/a.cpp:3: src/exact may not know src/base' \
  src/exact/a.cpp '#include <vector>' '' '#  include "base/memory.hpp"'
refuses 'src/grid may not know src/search' src/grid/a.hpp '#include "search/find_at_risk.hpp"'
refuses 'src/grid may not know processor intrinsics' src/grid/a.cpp '#include <immintrin.h>'
refuses 'src/search may not know the system' src/search/a.cpp '#include <sys/mman.h>'
refuses 'src/geodesy may not know src/exact' src/geodesy/a.cpp '#include "exact/a.hpp"'
refuses 'src/brute_force may not know src/grid' src/brute_force/a.cpp '#include "grid/a.hpp"'
refuses 'src/kernels may not know src/search' src/kernels/a.cpp '#include "search/a.hpp"'
refuses 'src/motion may not know src/motion/live' src/motion/a.cpp '#include "motion/live/a.hpp"'
refuses 'analysis/recorded may not know cli/console' \
  analysis/recorded/a.cpp '#include "cli/console/terminal.hpp"'
refuses 'cli/detect may not know cli/watch' cli/detect/a.cpp '#include "cli/watch/a.hpp"'
refuses 'cli/watch may not know libraries' cli/watch/a.cpp '#include <CLI/CLI.hpp>'
refuses 'cli/console may not know cli/detect' cli/console/a.cpp '#include "cli/detect/a.hpp"'
refuses 'report may not know report/figure' report/a.cpp '#include "report/figure/figure.hpp"'
refuses 'cli may not know src/exact' cli/a.cpp '#include "exact/exact_distance.hpp"'
refuses 'cli may not know src/exact' cli/a.cpp '#include "src/exact/exact_distance.hpp"'
refuses 'io/table may not know io/points' io/table/a.cpp '#include "io/points/a.hpp"'
refuses 'io may not know scenes' io/a.cpp '#include "scenes/a.hpp"'
refuses 'scenes may not know io' scenes/a.cpp '#include "io/a.hpp"'
refuses 'examples may not know io' examples/a.cpp '#include "io/a.hpp"'
refuses 'write the room too' src/exact/a.cpp '#include "a.hpp"'
refuses 'write the room too' src/exact/a.cpp '#include "../base/a.hpp"'
refuses 'in angle brackets' cli/a.cpp '#include "beespace/point.hpp"'
refuses 'this folder has no rule' new_room/a.cpp '#include <vector>'
refuses 'no C++ files' README.md 'nothing to check is not a success'
