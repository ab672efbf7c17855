#!/usr/bin/env bash
# The kernels are compiled for processors that the rest of the library must not require. If the
# linker chose an inline function of theirs for all callers (a weak symbol), older processors would
# crash. Each kernel's object file must define its entry and nothing else that is shared.
set -euo pipefail

symbols=$(nm -C --defined-only "$1" 2>/dev/null)
# One variant a file: sweep_baseline.cpp, crowd_avx2.cpp, ... (crowd_kernels.cpp chooses among them)
kernels=$(grep -E '^(sweep|tree_walk|crowd)_[a-z0-9]+\.cpp\.o:$' <<<"$symbols" | grep -vc '^crowd_kernels' || true)
[ "$kernels" -ge 3 ] || { echo "$kernels kernel objects in $1, not three or more" >&2; exit 1; }

awk '
  /^[^ ]+\.o:$/ { kernel = /^(sweep|tree_walk|crowd)_[a-z0-9]+\.cpp/ && !/^crowd_kernels/; next }
  kernel && NF >= 3 {
    shared = $2 ~ /^[TWui]$/  # code; weak data (type names for sanitizers) does no harm
    if (shared && !($2 == "T" && $3 ~ /^beespace::cpu::(tree_walks?_|crowd_)/)) { print "shared: " $0; bad = 1 }
    if ($2 ~ /^[TDR]$/ && $3 ~ /^beespace::cpu::/) entries++
  }
  END { if (bad || entries < 1) exit 1; print entries " kernel entries, nothing else shared" }
' <<<"$symbols"
