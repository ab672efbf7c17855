#!/usr/bin/env bash
# Proves that the manual page is well formed: mandoc, or else groff, has nothing to say about it.
#
#   manual_test.sh SOURCE_FOLDER          (exits 77, "skipped", where neither is there)
set -euo pipefail
page=$1/man/beespace.1

if command -v mandoc > /dev/null; then
  mandoc -T lint -W warning "$page"
elif command -v groff > /dev/null; then
  complaints=$(groff -man -ww -T utf8 -K utf8 "$page" 2>&1 > /dev/null)
  if [ -n "$complaints" ]; then
    echo "$complaints"
    exit 1
  fi
else
  echo "skipped: neither mandoc nor groff is installed"
  exit 77
fi
