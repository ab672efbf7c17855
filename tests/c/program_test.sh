#!/usr/bin/env bash
# Proves that the header is C99 without a warning, and C++ too, and that the example in C runs with
# the shared library and prints what its document says.
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

"$compiler" -std=c99 "${warnings[@]}" -I"$source/include" "$source/examples/pairs_in_c.c" \
  -L"$library" -lbeespace -o "$scratch/program"
LD_LIBRARY_PATH=$library "$scratch/program" > "$scratch/printed"
awk '/^<!-- output of pairs_in_c -->$/ {found = NR}
  found && NR > found + 1 && /^```/ {exit}
  found && NR > found + 1' "$source/docs/c.md" > "$scratch/shown"
diff "$scratch/shown" "$scratch/printed"
