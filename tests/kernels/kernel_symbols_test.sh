#!/usr/bin/env bash
# The kernels are compiled for processors that the rest of the library must not require. If the
# linker chose an inline function of theirs for all callers (a weak symbol), older processors would
# crash. Each kernel's object file must define its entry and nothing else that is shared.
set -euo pipefail

# One variant a file: sweep_avx2.cpp, crowd_avx2.cpp, ...
sets=()
for file in "$(dirname "$0")"/../../src/kernels/sweep_*.cpp; do
  name=${file##*/sweep_}
  sets+=("${name%.cpp}")
done
variant="^(sweep|tree_walk|crowd|box)_($(IFS='|'; echo "${sets[*]}"))[.]cpp"

symbols=$(nm -C --defined-only "$1" 2>/dev/null)
kernels=$(grep -cE "$variant" <<<"$symbols" || true)
[ "$kernels" -ge 3 ] || { echo "$kernels kernel objects in $1, not three or more" >&2; exit 1; }

awk -v variant="$variant" '
  /^[^ ]+\.o:$/ { kernel = $0 ~ variant; next }
  kernel && NF >= 3 {
    shared = $2 ~ /^[TWui]$/  # code; weak data (type names for sanitizers) does no harm
    if (shared && !($2 == "T" && $3 ~ /^beespace::cpu::(tree_walks?_|crowd_)/)) { print "shared: " $0; bad = 1 }
    if ($2 ~ /^[TDR]$/ && $3 ~ /^beespace::cpu::/) entries++
  }
  END { if (bad || entries < 1) exit 1; print entries " kernel entries, nothing else shared" }
' <<<"$symbols"
