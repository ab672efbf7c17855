#!/usr/bin/env bash
# Looks at pages that the command has made as a person would, in a real browser. Exits with 77,
# "skipped", where there is none.
#
#   browser_test.sh SOURCE_FOLDER COMMAND FOLDER       (FOLDER: where the pages go)
set -euo pipefail
source=$1 command=$2 folder=$3

browser=${BEESPACE_CHROMIUM:-$(command -v chromium || command -v google-chrome || true)}
if [ -z "$browser" ]; then
  echo "skipped: there is no Chromium here (on Ubuntu it is a snap, which a test cannot start)"
  exit 77
fi
rm -rf "$folder"
bash "$source/tests/web/make_pages.sh" "$command" "$folder"
BEESPACE_CHROMIUM=$browser BEESPACE_PAGES=$folder npm --prefix "$source/web" run --silent test:browser
