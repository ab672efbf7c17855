# shellcheck shell=bash
# Completion of the beespace command for bash.

# Offers what compgen finds for the arguments.
_beespace_offer() {
  local found
  found=$(compgen "$@") || true
  COMPREPLY=()
  [ -z "$found" ] || mapfile -t COMPREPLY <<< "$found"
}

_beespace() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  local subcommand=${COMP_WORDS[1]:-}
  COMPREPLY=()

  # bash splits --crs=wgs84 at the "=" into three words.
  if [ "$current" = = ]; then
    current=''
  elif [ "$previous" = = ] && [ "$COMP_CWORD" -ge 2 ]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi

  if [ "$COMP_CWORD" -eq 1 ]; then
    _beespace_offer -W 'detect predict replay watch advise simulate verify report view plot
      export generate bench help --help --version' -- "$current"
    return
  fi

  local words=''
  case $subcommand:$previous in
    help:help) words='detect predict replay watch advise simulate verify report view plot export generate
      bench' ;;
    detect:--report) words='at-risk pairs neighbors counts nearest groups closest-pair' ;;
    replay:--report) words='conflicts bees separation events' ;;
    *:--crs) words='auto wgs84 metres' ;;
    *:--time-unit) words='auto s ms us ns' ;;
    watch:--clock) words='report arrival' ;;
    *:--heights) words='auto geometric pressure' ;;
    advise:--method) words='certified orca mvp' ;;
    simulate:--method) words='certified orca mvp none' ;;
    advise:--acceleration | simulate:--acceleration | watch:--max-acceleration) words='none' ;;
    detect:--format) words='auto text npy bin' ;;
    export:--format) words='kml czml geojson csv' ;;
    generate:--scene) words='uniform clusters area flight head-on crossing sphere-swap encounters' ;;
    generate:--area) words='medellin' ;;
    generate:--format) words='csv tsv npy bin csv.gz tsv.gz npy.gz bin.gz' ;;
    *:--output | *:-o | *:--compare | *:--others | *:--obstacles | *:--intruders)
      compopt -o filenames
      _beespace_offer -f -- "$current"
      return
      ;;
    *:--threshold | *:--columns | *:--units | *:--threads | *:--max-results | *:--points) return ;;
    *:--vertical | *:--horizon | *:--max-age | *:--every | *:--max-gap | *:--tolerance) return ;;
    *:--leave-factor | *:--look-every | *:--rate | *:--max-skew | *:--max-bees | *:--max-pairs) return ;;
    *:--size | *:--clusters | *:--sigma | *:--seed) return ;;
    *:--speed | *:--miss | *:--duration | *:--interval) return ;;
    *:--bees | *:--spacing | *:--step | *:--steps | *:--clearance) return ;;
    *:--uncertainty | *:--intruder-horizon) return ;;
    *:--max-speed | *:--max-acceleration | *:--port | *:--width | *:--title) return ;;
    *)
      case $subcommand in
        detect)
          words='--report --others --threshold --vertical --inclusive --at-risk-only --max-results
            --threads --crs --columns --units --heights --format --skip-bad --unique-ids --output --csv --json --geojson
            --fail-on-risk --quiet --help --version'
          ;;
        predict)
          words='--threshold --vertical --inclusive --horizon --max-results --threads --crs --columns --units
            --time-unit --heights --max-age --grounded --skip-bad --output --csv --json --fail-on-risk --quiet
            --help --version'
          ;;
        replay)
          words='--report --every --threshold --vertical --inclusive --max-results --threads --crs
            --columns --units --time-unit --heights --max-gap --tolerance --grounded --skip-bad --horizon
            --leave-factor --look-every --output --csv --json --fail-on-risk --quiet --help
            --version'
          ;;
        watch)
          words='--threshold --vertical --horizon --leave-factor --look-every --advise --max-speed
            --max-acceleration --uncertainty --step --max-bees --max-pairs --max-age --clock --max-skew
            --speed --rate --threads --crs --columns --units --time-unit --heights --fail-on-risk --quiet
            --help --version'
          ;;
        advise)
          words='--speed --acceleration --step --threshold --uncertainty --obstacles --clearance
            --intruders --intruder-horizon --method --threads --output --json --fail-on-risk --quiet
            --help --version'
          ;;
        simulate)
          words='--bees --spacing --seed --speed --acceleration --step --steps --threshold --method
            --obstacles --clearance --threads --output --json --fail-on-risk --quiet --help --version'
          ;;
        verify)
          words='--threshold --max-speed --max-acceleration --obstacles --clearance --max-gap --straight --threads
            --crs --columns --units --time-unit --heights --grounded --skip-bad --output --csv --json --quiet
            --help --version'
          ;;
        report)
          words='--threshold --vertical --inclusive --threads --crs --columns --units --time-unit
            --heights --grounded --skip-bad --max-gap --tolerance --compare --output --json
            --fail-on-risk --quiet --help --version'
          ;;
        view)
          words='--threshold --vertical --inclusive --threads --crs --columns --units --time-unit
            --heights --grounded --skip-bad --max-gap --tolerance --compare --no-open --port
            --json --quiet --help --version'
          ;;
        plot)
          words='--threshold --vertical --inclusive --threads --crs --columns --units --time-unit
            --heights --grounded --skip-bad --max-gap --tolerance --width --title --output
            --json --fail-on-risk --quiet --help --version'
          ;;
        export)
          words='--threshold --vertical --inclusive --threads --crs --columns --units --time-unit
            --heights --grounded --skip-bad --max-gap --tolerance --format --output --json
            --fail-on-risk --quiet --help --version'
          ;;
        generate)
          words='--scene --area --points --size --clusters --sigma --speed --miss --duration
            --interval --seed --format --output --quiet --help --version'
          ;;
        bench) words='--points --threads --json --quiet --help --version' ;;
      esac
      case $subcommand:$current in
        *:-*) ;;
        simulate:*)
          # A scenario, or else a file of starts and goals.
          words='random-swap sphere-swap crossing-streams funnel pillars head-on density-sweep'
          if ! compgen -W "$words" -- "$current" > /dev/null; then
            compopt -o filenames
            _beespace_offer -f -- "$current"
            return
          fi
          ;;
        detect:* | predict:* | replay:* | watch:* | advise:* | verify:* | report:* | view:* | \
          plot:* | export:*)
          compopt -o filenames
          _beespace_offer -f -- "$current"
          return
          ;;
      esac
      ;;
  esac
  _beespace_offer -W "$words" -- "$current"
}
complete -F _beespace beespace
