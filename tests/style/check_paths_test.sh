#!/usr/bin/env bash
# Proves that scripts/check-paths finds paths of one machine, and nothing else.
#
#   check_paths_test.sh SOURCE_FOLDER
set -euo pipefail
source=$1
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT

fail() {
  echo "check_paths_test: $*" >&2
  exit 1
}

# Written in two parts, so that this file passes the check itself.
printf '%s\n' 'build/release/beespace' 'https://example.org/home/page' '/usr/share/man' > "$tree/a.md"
"$source/scripts/check-paths" "$tree" || fail "refused a tree with nothing wrong in it"

for path in '/ho''me/ann/swarm.csv' '/ro''ot/swarm.csv' "$tree/swarm.csv"; do
  printf 'first line\nsee %s\n' "$path" > "$tree/b.md"
  if output=$("$source/scripts/check-paths" "$tree" 2>&1); then fail "accepted $path"; fi
  [[ "$output" == *b.md:2:* ]] || fail "did not name file and line: $output"
done
