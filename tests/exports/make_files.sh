#!/usr/bin/env bash
# Exports a file of each community in every format, with the answers that the exports must agree
# with: NAME.kml, NAME.czml, NAME.geojson and NAME.json.
#
#   make_files.sh SOURCE_FOLDER COMMAND FOLDER
set -euo pipefail
source=$1 command=$2 folder=$3
rm -rf "$folder"
mkdir -p "$folder"
examples=$source/examples/data
tests=$source/tests/cli

export_as() {
  local name=$1 format
  shift
  for format in kml czml geojson; do
    "$command" export "$@" --output "$folder/$name.$format" --quiet
  done
}

# A swarm at one moment, a table of aircraft, a log of drones.
export_as swarm "$examples/bees-1000.csv"
"$command" detect "$examples/bees-1000.csv" --report pairs --output "$folder/swarm.json" --quiet
export_as aircraft "$examples/traffic.csv" --separation enroute --units aviation
"$command" replay "$examples/traffic.csv" --separation enroute --units aviation \
  --output "$folder/aircraft.json" --quiet
export_as drones "$tests/robotics/both.tlog"
"$command" replay "$tests/robotics/both.tlog" --output "$folder/drones.json" --quiet

# A show in metres among obstacles of each kind.
cat > "$folder/obstacles.json" << 'JSON'
{"obstacles": [
  {"kind": "cylinder", "center": [-20, 0], "radius_m": 4, "high_m": 30},
  {"kind": "cylinder", "center": [-20, 20], "radius_m": 0, "low_m": 0, "high_m": 30},
  {"kind": "box", "low": [30, -10, 0], "high": [40, 10, 12]},
  {"kind": "ground", "height_m": 0},
  {"kind": "prism", "outline": [[50, 0], [90, 0], [90, 30], [70, 10], [50, 30]], "low_m": 20, "high_m": 40},
  {"kind": "sphere", "center": [0, 40, 20], "radius_m": 5}
]}
JSON
export_as show "$examples/show-draft.skyc" --origin 19.06,47.47,130,30 --obstacles "$folder/obstacles.json"
"$command" replay "$examples/show-draft.skyc" --output "$folder/show.json" --quiet

# Times that do not count from 1970, a bee that is unknown for a while, both over the antimeridian.
awk 'BEGIN {print "id,time_s,longitude,latitude,height"
  for (t = 0; t <= 40; t += 0.5) {
    east = 179.999 + t * 5e-5
    if (east > 180) east -= 360
    printf "a,%.1f,%.7f,-17.5,120\n", t, east
    if (t <= 12 || t >= 18) printf "b,%.1f,-180,%.7f,121\n", t, -17.5 + (t - 21) * 1e-5
  }}' > "$folder/gap.csv"
export_as gap "$folder/gap.csv" --threshold 20 --max-gap 2
"$command" replay "$folder/gap.csv" --threshold 20 --max-gap 2 --output "$folder/gap.json" --quiet
