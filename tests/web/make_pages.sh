#!/usr/bin/env bash
# Makes the pages that web/tests/browser looks at, by the command itself: from swarms that it
# generates, flies, and with ids that mean harm.
#
#   make_pages.sh COMMAND FOLDER
set -euo pipefail
command=$1 folder=$2
data=$folder/data
mkdir -p "$data"

quietly() { "$command" "$@" --quiet; }
page() { quietly report "${@:2}" --output "$folder/$1.html"; }

quietly generate --area medellin --points 1000 --seed 7 --output "$data/bees.csv"
# With ids: aircraft have call signs.
awk -F, 'NR == 1 {print "id,lon,lat,height"; next} {printf "N%05d,%s\n", NR * 7919 % 100000, $0}' \
  "$data/bees.csv" > "$data/named.csv"
page snapshot "$data/named.csv" --threshold 100
page calm "$data/named.csv" --threshold 0.01
page cylinder "$data/named.csv" --threshold 150 --vertical 30
quietly generate --area medellin --points 1000 --seed 8 --output "$data/other.csv"
page compared-snapshots "$data/bees.csv" --compare "$data/other.csv" --threshold 100
quietly generate --points 100000 --size 1000 --seed 3 --output "$data/many.npy"
page hundred-thousand "$data/many.npy" --threshold 12
quietly generate --points 1000000 --size 5000 --seed 5 --output "$data/million.npy"
page million "$data/million.npy" --threshold 25

# Aircraft over a wide area, heights in feet: two cross, 300 ft apart, at 900 s; others far away.
awk 'BEGIN {print "id,time_s,longitude,latitude,height_ft"; for (t = 0; t <= 1800; t += 10) {
  printf "DLH4AB,%d,%.6f,47.4,36000\nRYR81K,%d,8.5,%.6f,36300\n", t, 8.5 + (t - 900) * 0.003, t, 47.4 - (t - 905) * 0.002
  printf "WEST,%d,%.6f,43,31000\nEAST,%d,%.6f,54,39000\n", t, -4 + t * 0.001, t, 16 + t * 0.001}}' > "$data/wide.csv"
page wide "$data/wide.csv" --threshold 5NM --vertical 1000ft

quietly simulate random-swap --bees 200 --method none --output "$data/before.csv"
quietly simulate random-swap --bees 200 --output "$data/after.csv"
page recording "$data/before.csv" --threshold 5
# By the clock of a computer, in seconds since 1970.
awk -F, -v OFS=, 'NR > 1 {$1 = sprintf("%.3f", $1 + 1700000000)} {print}' "$data/before.csv" > "$data/epoch.csv"
page epoch "$data/epoch.csv" --threshold 5
# Times of which a double is a little more than the step that the page rounds them to.
awk 'BEGIN {print "id,time_s,x,y,z"; for (b = 0; b < 4; ++b) for (k = 0; k <= 23; ++k)
  printf "%d,%.2f,%d,%d,0\n", b, 1700000000 + k / 20, 3 * b, k}' > "$data/end.csv"
page end "$data/end.csv" --threshold 5
# Two meet four times, away in between; another two once.
awk 'BEGIN {print "id,time_s,x,y,z"; for (k = 0; k <= 120; ++k) if (k <= 40 || k >= 60) {
  printf "a,%d,0,0,0\nb,%d,%d,0,0\n", k, k, 3 + (k % 30 < 15 ? 0 : 10)}
  for (k = 0; k <= 120; ++k) printf "c,%d,500,0,0\nd,%d,%d,0,0\n", k, k, 504 + (k - 70) * (k - 70)}' > "$data/again.csv"
page again "$data/again.csv" --threshold 5 --max-gap 5
page compared-recordings "$data/before.csv" --compare "$data/after.csv" --threshold 5
# A fleet that is not exact, and what its planner said.
quietly simulate random-swap --bees 20 --steps 200 --noise 0.1 --gust 0.3 --loss 20% --weak 10%:0.3 \
  --output "$data/flown.csv" --fleet-log "$data/fleet.ndjson"
page fleet "$data/flown.csv" --fleet-log "$data/fleet.ndjson" --threshold 5
quietly generate --scene flight --points 1000 --size 400 --duration 1000 --interval 0.2 --seed 4 \
  --output "$data/long.csv"
page long-recording "$data/long.csv" --threshold 5

# A show that declares limits and cues, between what stands in its way.
echo '{"obstacles": [{"kind": "cylinder", "center": [0, -6], "radius_m": 1, "high_m": 20},
  {"kind": "box", "low": [4, 4, 0], "high": [7, 6, 8]}]}' > "$data/obstacles.json"
page show "$(dirname "$0")/../cli/shows/ring.skyc" --obstacles "$data/obstacles.json"
# Two that come nearer to each other for long.
awk 'BEGIN {print "id,time_s,x,y,z"; for (t = 0; t <= 6000; t += 100) printf "a,%d,%d,0,0\nb,%d,%d,0,0\n", t, t, t, 9000 - t}' \
  > "$data/slow.csv"
page slow "$data/slow.csv" --threshold 5
# One that never takes off, one that lands beside it, and another in the air.
path() { echo "{\"type\": \"generic\", \"settings\": {\"name\": \"$1\", \"trajectory\": {\"version\": 1, \"points\": [$2], \"takeoffTime\": 0}}}"; }
echo "{\"version\": 1, \"settings\": {}, \"swarm\": {\"drones\": [
  $(path spare '[0, [0, 0, 0], []], [60, [0, 0, 0], []]'),
  $(path lands '[0, [20, 0, 0], []], [3, [20, 0, 5], []], [6, [-1, 0, 5], []], [9, [-1, 0, 0], []]'),
  $(path passes '[0, [40, 0, 0], []], [3, [40, 0, 5], []], [6, [10, 0, 5], []], [9, [10, 0, 0], []]')]}}" > "$data/standing.json"
page standing "$data/standing.json" --threshold 1.5
# Without heights: the corners of a square, one of which another comes close to.
awk 'BEGIN {print "id,time_s,x,y"; for (t = 0; t <= 20; ++t)
  printf "a,%d,0,0\nb,%d,40,0\nc,%d,40,40\nd,%d,%d,37\n", t, t, t, t, 20 + t}' > "$data/flat.csv"
page flat "$data/flat.csv" --threshold 5

# A video, whose rows count downwards; two on dates that name no zone; and drones while clocks are set back.
awk 'BEGIN {print "id,frame,x_px,y_px"; for (f = 0; f <= 50; ++f) printf "a,%d,%d,10\nb,%d,%d,400\n", f, 10 + f, f, 600 - f}' > "$data/video.csv"
page video "$data/video.csv" --threshold 3mm --fps 25 --scale 0.1mm
awk 'BEGIN {print "animal,time,x_m,y_m"; for (s = 0; s < 60; ++s)
  printf "Anna,2024-07-01 12:00:%02d,%d,0\nBert,2024-07-01 12:00:%02d,%d,3\n", s, s, s, 40 - s}' > "$data/unnamed.csv"
page unnamed "$data/unnamed.csv" --threshold 5
awk 'BEGIN {print "id,time_s,x,y,z"; for (t = 0; t <= 7200; t += 60)
  printf "a,%d,%d,0,0\nb,%d,%d,3,0\n", 1729987200 + t, t, 1729987200 + t, 7200 - t}' > "$data/zoned.csv"
page zoned "$data/zoned.csv" --threshold 5 --time-zone Europe/Berlin

# In a line that was turned and turned back: as wide as a rounding error.
printf 'x,y,z\n0,10,0.3\n10,9.999999999999998,0.30000000000000004\n' > "$data/line.csv"
page line "$data/line.csv" --threshold 5
# One bee, no extent, or no time.
printf 'id,x,y,z\nalone,1,2,3\n' > "$data/one.csv"
page one-bee "$data/one.csv" --threshold 5
printf 'id,x,y,z\na,3,3,3\nb,3,3,3\nc,3,3,3\n' > "$data/same.csv"
page same-place "$data/same.csv" --threshold 5
printf 'id,time_s,x,y,z\na,0,1,2,3\nb,5,4,5,6\n' > "$data/fixes.csv"
page one-fix-each "$data/fixes.csv" --threshold 5

# A thousand bees, ten kinds of ids; the file's name is one of them.
hostile="$data/<img src=x onerror=window.__pwned=1>.csv"
node - "$data/bees.csv" "$hostile" << 'JAVASCRIPT'
const { readFileSync, writeFileSync } = require('node:fs');
const ids = ['<img src=x onerror="window.__pwned = 1">', '</script><script>window.__pwned = 1</script>',
  '"><svg onload=window.__pwned=1>', '\u202eevil\u202d right to left \u05d0\u05d1\u05d2',
  '\u{1F41D}\u{1F41D}\u200d\u{1F469} & <b>bold</b>', '{{constructor}}${7*7}',
  "'; window.__pwned = 1; //", '\u2028\u2029 lines', '0', 'x'.repeat(10000)];
const [bees, hostile] = process.argv.slice(2);
const rows = readFileSync(bees, 'utf8').trimEnd().split('\n').slice(1);
const named = rows.map((row, i) => {
  const id = ids[i % ids.length] + (i < 10 ? '' : ` ${i}`);
  return `"${id.replaceAll('"', '""')}",${row}\n`;
});
writeFileSync(hostile, `id,lon,lat,height\n${named.join('')}`);
JAVASCRIPT
page hostile "$hostile" --threshold 100
