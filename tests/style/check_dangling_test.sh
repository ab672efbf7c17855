#!/usr/bin/env bash
# Proves that Clang warns where a view of the public headers outlives what it refers to, and nowhere
# else: the lines of dangling.cpp that are marked, and no others.
#
#   check_dangling_test.sh SOURCE_FOLDER CLANG
set -euo pipefail
source=$1
clang=$2
example=$source/tests/style/dangling.cpp

output=$("$clang" -std=c++20 -Wall -Wextra "-I$source/include" -fsyntax-only "$example" 2>&1)
warned=$(sed -nE 's|^.*dangling\.cpp:([0-9]+):[0-9]+: warning: .*|\1|p' <<< "$output" | sort -nu)
expected=$(grep -n '// dangles$' "$example" | cut -d: -f1 | sort -nu)
if [ "$warned" != "$expected" ]; then
  echo "check_dangling_test: warned (<) and expected (>) lines of dangling.cpp differ:" >&2
  diff <(printf '%s\n' "$warned") <(printf '%s\n' "$expected") >&2 || true
  printf '%s\n' "$output" >&2
  exit 1
fi
