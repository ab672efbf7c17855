#!/usr/bin/env bash
# Reads exports with what others wrote: KML with xmllint, GeoJSON with check-geojson, and compares
# GeoJSON and CZML with the answers. scripts/check-exports opens them with Cesium, too.
#
#   read_test.sh SOURCE_FOLDER COMMAND FOLDER       (FOLDER: where the exports go)
set -euo pipefail
source=$1 command=$2 folder=$3

bash "$source/tests/exports/make_files.sh" "$source" "$command" "$folder"
if command -v xmllint > /dev/null; then
  xmllint --noout --nonet "$folder"/*.kml
  echo "xmllint: $(printf '%s\n' "$folder"/*.kml | wc -l) KML files are well-formed"
else
  echo "xmllint is not here (Debian: libxml2-utils): KML is not looked at"
fi
node "$source/tests/exports/check_json.mjs" "$folder"
