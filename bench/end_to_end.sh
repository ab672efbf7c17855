#!/usr/bin/env bash
# How long the whole command takes, from file to ids, as a multiple of a newline scan (memchr) of the
# same file, on one core and on two, for a million lines and for ten million.
# usage: bench/end_to_end.sh [BUILD_FOLDER]
set -euo pipefail
build=${1:-build/release}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

for points in 1000000 10000000; do
  file=$folder/bees-$points.csv
  "$build/beespace" generate --area medellin --points "$points" --seed 7 --quiet --output "$folder/short.csv"
  # Heights with eleven decimals as well: about 50 bytes a line.
  awk 'NR == 1 { print; next } { print $0 substr($0, 5, 9) }' "$folder/short.csv" >"$file"
  rm "$folder/short.csv"
  for threads in 1 2; do
    printf '%s threads: %s  ' "$(basename "$file")" "$threads"
    "$build/end_to_end_benchmark" "$file" "$folder/ids.txt" \
      "$build/beespace" detect "$file" --threads "$threads" --output "$folder/ids.txt"
  done
done
