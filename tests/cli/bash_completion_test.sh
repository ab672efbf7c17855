#!/usr/bin/env bash
# Proves that the completion for bash offers the words that fit, also behind an "=".
#
#   bash_completion_test.sh COMPLETION_FILE
set -euo pipefail
# shellcheck source=/dev/null
source "$1"
wrong=0

# bash itself has this only while Tab is pressed.
# shellcheck disable=SC2317
compopt() { :; }

# expect "WORDS OFFERED" WORD...: the words as bash splits them, the last one being completed.
expect() {
  local offered=$1
  shift
  COMP_WORDS=("$@")
  COMP_CWORD=$(($# - 1))
  COMPREPLY=()
  _beespace
  [ "${COMPREPLY[*]}" = "$offered" ] ||
    { echo "'$*' offers '${COMPREPLY[*]}' instead of '$offered'"; wrong=1; }
}

expect "detect" beespace det
expect "help" beespace he
expect "generate" beespace help gen
expect "auto wgs84 metres" beespace detect --crs ""
expect "auto wgs84 metres" beespace detect --crs =
expect "wgs84" beespace detect --crs = w
expect "npy npy.gz" beespace generate --format = np
expect "--threshold --threads" beespace detect --thr
expect "neighbors nearest" beespace detect --report ne
expect "closest-pair" beespace detect --report = cl
expect "$1" beespace detect --others "${1%sh}"
expect "bench" beespace be
expect "--points" beespace bench --po
expect "" beespace detect --threshold = 5
expect "$1" beespace detect --output = "${1%sh}"
expect "--quiet" beespace generate --qu
expect "predict" beespace pre
expect "replay" beespace help repl
expect "replay report" beespace help rep
expect "--horizon" beespace predict --ho
expect "--time-unit --time-zone" beespace replay --ti
expect "auto s ms us ns" beespace predict --time-unit ""
expect "ms" beespace replay --time-unit = m
expect "conflicts pairs bees separation events" beespace replay --report ""
expect "separation" beespace replay --report = se
expect "auto wgs84 metres" beespace replay --crs ""
expect "" beespace predict --horizon ""
expect "watch" beespace wa
expect "watch" beespace help wa
expect "--leave-factor" beespace watch --le
expect "--speed" beespace watch --sp
expect "auto s ms us ns" beespace watch --time-unit ""
expect "wgs84" beespace watch --crs = w
expect "" beespace watch --rate ""
expect "$1" beespace watch "${1%sh}"
expect "--vertical" beespace detect --vert
expect "" beespace replay --max-gap = 5
expect "$1" beespace predict "${1%sh}"
expect "$1" beespace replay show.skyc "${1%sh}"
expect "crossing" beespace generate --scene cr
expect "head-on" beespace generate --scene = he
expect "--speed" beespace generate --sp
expect "" beespace generate --duration ""
expect "simulate" beespace si
expect "advise" beespace ad
expect "advise" beespace help ad
expect "--uncertainty" beespace advise --un
expect "--intruders --intruder-horizon" beespace advise --intr
expect "certified orca mvp" beespace advise --method ""
expect "none" beespace advise --acceleration ""
expect "$1" beespace advise "${1%sh}"
expect "$1" beespace advise swarm.csv --obstacles "${1%sh}"
expect "$1" beespace advise --intruders = "${1%sh}"
expect "" beespace advise --intruder-horizon ""
expect "--advise" beespace watch --adv
expect "none" beespace watch --max-acceleration ""
expect "verify" beespace help ve
expect "random-swap sphere-swap crossing-streams funnel pillars head-on density-sweep" \
  beespace simulate ""
expect "sphere-swap" beespace simulate sp
expect "crossing-streams" beespace simulate cr
expect "$1" beespace simulate "${1%sh}"
expect "$1" beespace simulate funnel --obstacles "${1%sh}"
expect "" beespace simulate pillars --clearance ""
expect "certified orca mvp none" beespace simulate --method ""
expect "none" beespace simulate --acceleration = n
expect "--step --steps" beespace simulate random-swap --step
expect "" beespace simulate --bees ""
expect "$1" beespace simulate head-on --output "${1%sh}"
expect "--max-speed --max-acceleration --max-horizontal --max-climb --max-descent --max-height --max-gap" beespace verify --max
expect "wgs84" beespace verify --crs = w
expect "" beespace verify --max-speed ""
expect "$1" beespace verify a.csv "${1%sh}"
exit "$wrong"
