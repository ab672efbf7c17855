#!/usr/bin/env bash
# Proves that the header is C99 without a warning, and C++ too, and that the examples in C run with
# the shared library and print what their document says.
#
#   program_test.sh SOURCE_FOLDER LIBRARY_FOLDER COMPILER
set -euo pipefail
source=$1 library=$2 compiler=$3

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

warnings=(-pedantic -Wall -Wextra -Werror -Wconversion -Wshadow)
for standard in c99 c11 c++11 c++20; do
  case $standard in
    c++*) language=c++ ;;
    *) language=c ;;
  esac
  printf '#include <beespace.h>\n#include <beespace.h>\n' |
    "$compiler" -x "$language" "-std=$standard" "${warnings[@]}" -I"$source/include" -fsyntax-only -
done

for example in pairs_in_c advice_in_c; do
  "$compiler" -std=c99 "${warnings[@]}" -I"$source/include" "$source/examples/$example.c" \
    -L"$library" -lbeespace -lm -o "$scratch/program"
  LD_LIBRARY_PATH=$library "$scratch/program" > "$scratch/printed"
  awk -v title="<!-- output of $example -->" '$0 == title {found = NR}
    found && NR > found + 1 && /^```/ {exit}
    found && NR > found + 1' "$source/docs/c.md" > "$scratch/shown"
  [ -s "$scratch/shown" ]
  diff "$scratch/shown" "$scratch/printed"
done
