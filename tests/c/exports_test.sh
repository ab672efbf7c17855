#!/usr/bin/env bash
# Proves that libbeespace.so exports what <beespace.h> declares and nothing else, each name with the
# version of the interface, and that it needs no library besides the system's.
#
#   exports_test.sh SOURCE_FOLDER LIBRARY
set -euo pipefail
source=$1 library=$2

mapfile -t declared < <(awk '/^BEESPACE_C_API/ {inside = 1; text = ""}
  inside {text = text " " $0}
  inside && /;$/ {if (match(text, /beespace_[a-z0-9_]+\(/)) print substr(text, RSTART, RLENGTH - 1); inside = 0}' \
  "$source"/include/beespace/c/*.h | sort)
exported=$(nm -D --defined-only "$library" | awk '$2 != "A" {print $3}' | sort)
if ! difference=$(diff <(printf '%s@@BEESPACE_1\n' "${declared[@]}") <(printf '%s\n' "$exported")); then
  printf 'declared (<) and exported (>) differ:\n%s\n' "$difference" >&2
  exit 1
fi

soname=$(readelf -d "$library" | sed -n 's/.*SONAME.*\[\(.*\)\]/\1/p')
if [ "$soname" != libbeespace.so.1 ]; then
  echo "the library calls itself '$soname', not libbeespace.so.1" >&2
  exit 1
fi
needed=$(readelf -d "$library" | sed -n 's/.*NEEDED.*\[\(.*\)\]/\1/p' |
  grep -vE '^(libstdc\+\+|libgcc_s|libm|libc|ld-linux.*)\.so' || true)
if [ -n "$needed" ]; then
  echo "the library needs others: $needed" >&2
  exit 1
fi
