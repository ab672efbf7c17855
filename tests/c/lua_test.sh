#!/usr/bin/env bash
# Proves that the example in Lua runs with the shared library and prints what its document says.
#
#   lua_test.sh SOURCE_FOLDER LIBRARY_FOLDER LUAJIT
set -euo pipefail
source=$1 library=$2 luajit=$3

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

LD_LIBRARY_PATH=$library "$luajit" "$source/examples/near_in_lua.lua" > "$scratch/printed"
awk '/^<!-- output of near_in_lua -->$/ {found = NR}
  found && NR > found + 1 && /^```/ {exit}
  found && NR > found + 1' "$source/docs/c.md" > "$scratch/shown"
[ -s "$scratch/shown" ] || { echo "docs/c.md does not show what the example prints" >&2; exit 1; }
diff "$scratch/shown" "$scratch/printed"
