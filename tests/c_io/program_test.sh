#!/usr/bin/env bash
# Proves that the header is C99 without a warning, and C++ too, and that the example in C runs with
# both shared libraries and prints what its document says.
#
#   program_test.sh SOURCE_FOLDER LIBRARY_FOLDER IO_LIBRARY_FOLDER COMPILER
set -euo pipefail
source=$1 library=$2 io_library=$3 compiler=$4

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

warnings=(-pedantic -Wall -Wextra -Werror -Wconversion -Wshadow)
for standard in c99 c11 c++11 c++20; do
  case $standard in
    c++*) language=c++ ;;
    *) language=c ;;
  esac
  printf '#include <beespace_io.h>\n#include <beespace_io.h>\n' |
    "$compiler" -x "$language" "-std=$standard" "${warnings[@]}" -I"$source/include" -fsyntax-only -
done

"$compiler" -std=c99 "${warnings[@]}" -I"$source/include" "$source/examples/read_in_c.c" \
  -L"$io_library" -lbeespace_io -L"$library" -lbeespace -o "$scratch/program"
export LD_LIBRARY_PATH=$library:$io_library
cd "$source"
"$scratch/program" examples/data/swarm.csv 5 > "$scratch/printed"
awk '/^<!-- output of read_in_c -->$/ {found = NR}
  found && NR > found + 1 && /^```/ {exit}
  found && NR > found + 1' docs/c.md > "$scratch/shown"
diff "$scratch/shown" "$scratch/printed"

if "$scratch/program" "$scratch/none.csv" 5 2> "$scratch/said"; then
  echo "a file that is not there was read" >&2
  exit 1
fi
grep -q "^$scratch/none.csv: " "$scratch/said"
