# shellcheck shell=bash
# Completion of the beespace command for bash.
# Written by scripts/write-completions from what --help says.

# Offers what compgen finds for the arguments.
_beespace_offer() {
  local found
  found=$(compgen "$@") || true
  COMPREPLY=()
  [ -z "$found" ] || mapfile -t COMPREPLY <<< "$found"
}

_beespace() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  local subcommand=${COMP_WORDS[1]:-} options='' values='' files=''
  COMPREPLY=()

  # bash splits --crs=wgs84 at the "=" into three words.
  if [ "$current" = = ]; then
    current=''
  elif [ "$previous" = = ] && [ "$COMP_CWORD" -ge 2 ]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi

  if [ "$COMP_CWORD" -eq 1 ]; then
    _beespace_offer -W 'detect predict replay watch advise guide follow simulate verify fleet report view plot export generate bench help --help --version' -- "$current"
    return
  fi

  case $subcommand in
    detect)
      case $previous in
        --crs) values='auto wgs84 metres' ;;
        --heights) values='auto geometric pressure' ;;
        --format) values='auto text npy bin' ;;
        --report) values='at-risk pairs neighbors counts nearest groups closest-pair' ;;
        --separation) values='enroute terminal well-clear-suas nmac' ;;
        --others | -o | --output) files=yes ;;
        --columns | --units | --threshold | --vertical | --max-results | --threads | --memory | --temporary) return ;;
        *) options='--others --crs --columns --units --heights --format --skip-bad --unique-ids --report --threshold --vertical --separation --inclusive --at-risk-only --max-results --threads --memory --temporary --output --csv --json --geojson --fail-on-risk --quiet --help --version' files=yes ;;
      esac
      ;;
    predict)
      case $previous in
        --crs) values='auto wgs84 metres' ;;
        --time-unit) values='auto s ms us ns' ;;
        --dates) values='auto day-first month-first' ;;
        --heights) values='auto geometric pressure' ;;
        --separation) values='enroute terminal well-clear-suas nmac' ;;
        -o | --output) files=yes ;;
        --columns | --time-zone | --fps | --scale | --least-likelihood | --units | --max-age | --threshold | --vertical | --threads | --max-results | --horizon) return ;;
        *) options='--crs --columns --time-unit --one-clock --time-zone --dates --fps --scale --least-likelihood --grounded --units --heights --skip-bad --max-age --threshold --vertical --separation --inclusive --threads --max-results --horizon --output --csv --json --fail-on-risk --quiet --help --version' files=yes ;;
      esac
      ;;
    replay)
      case $previous in
        --crs) values='auto wgs84 metres' ;;
        --time-unit) values='auto s ms us ns' ;;
        --dates) values='auto day-first month-first' ;;
        --heights) values='auto geometric pressure' ;;
        --max-gap) values='never' ;;
        --separation) values='enroute terminal well-clear-suas nmac' ;;
        --report) values='conflicts pairs bees separation events' ;;
        -o | --output) files=yes ;;
        --columns | --time-zone | --fps | --scale | --least-likelihood | --units | --tolerance | --threshold | --vertical | --threads | --max-results | --ignore-below | --every | --horizon | --leave-factor | --look-every | --memory | --temporary) return ;;
        *) options='--crs --columns --time-unit --one-clock --time-zone --dates --fps --scale --least-likelihood --grounded --units --heights --skip-bad --max-gap --tolerance --sector --straight --threshold --vertical --separation --inclusive --threads --max-results --ignore-below --report --every --horizon --leave-factor --look-every --memory --temporary --output --csv --json --fail-on-risk --quiet --help --version' files=yes ;;
      esac
      ;;
    watch)
      case $previous in
        --crs) values='auto wgs84 metres' ;;
        --time-unit) values='auto s ms us ns' ;;
        --dates) values='auto day-first month-first' ;;
        --heights) values='auto geometric pressure' ;;
        --clock) values='report arrival' ;;
        --separation) values='enroute terminal well-clear-suas nmac' ;;
        --max-acceleration) values='none' ;;
        --columns | --time-zone | --fps | --scale | --units | --max-age | --max-skew | --max-bees | --speed | --rate | --threshold | --vertical | --threads | --horizon | --leave-factor | --look-every | --max-pairs | --max-speed | --uncertainty | --step) return ;;
        *) options='--crs --columns --time-unit --one-clock --time-zone --dates --fps --scale --grounded --units --heights --max-age --clock --max-skew --max-bees --speed --rate --threshold --vertical --separation --threads --horizon --leave-factor --look-every --max-pairs --advise --max-speed --max-acceleration --uncertainty --step --fail-on-risk --quiet --help --version' files=yes ;;
      esac
      ;;
    advise)
      case $previous in
        --acceleration) values='none' ;;
        --method) values='certified orca mvp' ;;
        --obstacles | --intruders | -o | --output) files=yes ;;
        --speed | --step | --threshold | --uncertainty | --clearance | --intruder-horizon | --threads) return ;;
        *) options='--speed --acceleration --step --threshold --uncertainty --obstacles --clearance --intruders --intruder-horizon --method --threads --output --json --fail-on-risk --quiet --help --version' files=yes ;;
      esac
      ;;
    guide)
      case $previous in
        --shape) values='sphere' ;;
        --loop) values='onboard ground' ;;
        --format) values='ndjson mavlink' ;;
        --status) values='changes all none' ;;
        --obstacles | --store | --log) files=yes ;;
        --threshold | --fence | --clearance | --max-speed | --max-acceleration | --period | --command-delay | --longest-loss | --report-error | --report-age | --sensing-error | --loop-period | --loop-delay | --deviation | --clock-error | --correction-acceleration | --correction-speed | --epoch | --threads) return ;;
        *) options='--threshold --shape --obstacles --fence --clearance --plane --max-speed --max-acceleration --period --command-delay --longest-loss --loop --report-error --report-age --sensing-error --loop-period --loop-delay --deviation --clock-error --correction-acceleration --correction-speed --store --epoch --ticks-from-input --threads --format --log --status --quiet --help --version' ;;
      esac
      ;;
    follow)
      case $previous in
        --store) files=yes ;;
        --agent | --planned-speed | --planned-acceleration | --period | --radius | --start | --report-every) return ;;
        *) options='--agent --planned-speed --planned-acceleration --period --radius --start --store --ticks-from-input --simulated --report-every --setpoints --quiet --help --version' ;;
      esac
      ;;
    simulate)
      case $previous in
        --acceleration) values='none' ;;
        --method) values='certified orca mvp none' ;;
        --noise-kind) values='uniform adversarial' ;;
        --loop) values='onboard ground' ;;
        --shape) values='sphere' ;;
        --obstacles | --nominal | --fleet-log | -o | --output) files=yes ;;
        --bees | --spacing | --seed | --speed | --step | --steps | --threshold | --clearance | --threads | --noise | --gust | --drift | --latency | --loss | --loss-run | --clock-error | --weak | --silent | --joins | --intruders | --radius | --reserve | --command-delay | --fence) return ;;
        *) options='--bees --spacing --seed --speed --acceleration --step --steps --threshold --method --obstacles --clearance --threads --noise --noise-kind --gust --drift --latency --loss --loss-run --clock-error --weak --silent --joins --intruders --radius --loop --reserve --command-delay --shape --fence --plane --nominal --fleet-log --output --json --fail-on-risk --quiet --help --version' values='random-swap sphere-swap crossing-streams funnel pillars head-on density-sweep' files=yes ;;
      esac
      ;;
    verify)
      case $previous in
        --crs) values='auto wgs84 metres' ;;
        --time-unit) values='auto s ms us ns' ;;
        --dates) values='auto day-first month-first' ;;
        --heights) values='auto geometric pressure' ;;
        --separation) values='enroute terminal well-clear-suas nmac' ;;
        --max-gap) values='never' ;;
        --obstacles | -o | --output) files=yes ;;
        --columns | --time-zone | --fps | --scale | --least-likelihood | --units | --threshold | --vertical | --ignore-below | --max-speed | --max-acceleration | --max-horizontal | --max-climb | --max-descent | --max-height | --skip-limits | --clearance | --threads) return ;;
        *) options='--crs --columns --time-unit --one-clock --time-zone --dates --fps --scale --least-likelihood --grounded --units --heights --skip-bad --threshold --vertical --separation --ignore-below --max-speed --max-acceleration --max-horizontal --max-climb --max-descent --max-height --skip-limits --obstacles --clearance --max-gap --straight --threads --output --csv --json --quiet --help --version' files=yes ;;
      esac
      ;;
    fleet)
      case $previous in
        --crs) values='auto wgs84 metres' ;;
        --time-unit) values='auto s ms us ns' ;;
        --dates) values='auto day-first month-first' ;;
        --heights) values='auto geometric pressure' ;;
        --max-gap) values='never' ;;
        --set | -o | --output) files=yes ;;
        --columns | --time-zone | --fps | --scale | --least-likelihood | --units | --set-columns | --set-begins | --origin | --max-deviation) return ;;
        *) options='--crs --columns --time-unit --one-clock --time-zone --dates --fps --scale --least-likelihood --grounded --units --heights --skip-bad --set --set-columns --set-begins --origin --max-gap --max-deviation --output --csv --json --fail-on-risk --quiet --help --version' files=yes ;;
      esac
      ;;
    report)
      case $previous in
        --crs) values='auto wgs84 metres' ;;
        --time-unit) values='auto s ms us ns' ;;
        --dates) values='auto day-first month-first' ;;
        --heights) values='auto geometric pressure' ;;
        --max-gap) values='never' ;;
        --separation) values='enroute terminal well-clear-suas nmac' ;;
        --compare | --fleet-log | --obstacles | -o | --output) files=yes ;;
        --columns | --time-zone | --fps | --scale | --least-likelihood | --units | --tolerance | --threshold | --vertical | --threads | --ignore-below | --horizon) return ;;
        *) options='--crs --columns --time-unit --one-clock --time-zone --dates --fps --scale --least-likelihood --grounded --units --heights --skip-bad --max-gap --tolerance --sector --threshold --vertical --separation --inclusive --threads --ignore-below --horizon --compare --fleet-log --obstacles --output --json --fail-on-risk --quiet --help --version' files=yes ;;
      esac
      ;;
    view)
      case $previous in
        --crs) values='auto wgs84 metres' ;;
        --time-unit) values='auto s ms us ns' ;;
        --dates) values='auto day-first month-first' ;;
        --heights) values='auto geometric pressure' ;;
        --max-gap) values='never' ;;
        --separation) values='enroute terminal well-clear-suas nmac' ;;
        --compare | --fleet-log | --obstacles) files=yes ;;
        --columns | --time-zone | --fps | --scale | --least-likelihood | --units | --tolerance | --threshold | --vertical | --threads | --ignore-below | --horizon | --port) return ;;
        *) options='--crs --columns --time-unit --one-clock --time-zone --dates --fps --scale --least-likelihood --grounded --units --heights --skip-bad --max-gap --tolerance --sector --threshold --vertical --separation --inclusive --threads --ignore-below --horizon --compare --fleet-log --obstacles --no-open --port --json --quiet --help --version' files=yes ;;
      esac
      ;;
    plot)
      case $previous in
        --crs) values='auto wgs84 metres' ;;
        --time-unit) values='auto s ms us ns' ;;
        --dates) values='auto day-first month-first' ;;
        --heights) values='auto geometric pressure' ;;
        --max-gap) values='never' ;;
        --separation) values='enroute terminal well-clear-suas nmac' ;;
        -o | --output) files=yes ;;
        --columns | --time-zone | --fps | --scale | --least-likelihood | --units | --tolerance | --threshold | --vertical | --threads | --ignore-below | --horizon | --width | --title) return ;;
        *) options='--crs --columns --time-unit --one-clock --time-zone --dates --fps --scale --least-likelihood --grounded --units --heights --skip-bad --max-gap --tolerance --sector --threshold --vertical --separation --inclusive --threads --ignore-below --horizon --output --width --title --json --fail-on-risk --quiet --help --version' files=yes ;;
      esac
      ;;
    export)
      case $previous in
        --crs) values='auto wgs84 metres' ;;
        --time-unit) values='auto s ms us ns' ;;
        --dates) values='auto day-first month-first' ;;
        --heights) values='auto geometric pressure' ;;
        --max-gap) values='never' ;;
        --separation) values='enroute terminal well-clear-suas nmac' ;;
        --format) values='kml czml geojson csv' ;;
        -o | --output | --obstacles) files=yes ;;
        --columns | --time-zone | --fps | --scale | --least-likelihood | --units | --tolerance | --threshold | --vertical | --threads | --ignore-below | --horizon | --origin) return ;;
        *) options='--crs --columns --time-unit --one-clock --time-zone --dates --fps --scale --least-likelihood --grounded --units --heights --skip-bad --max-gap --tolerance --sector --threshold --vertical --separation --inclusive --threads --ignore-below --horizon --output --format --origin --obstacles --json --fail-on-risk --quiet --help --version' files=yes ;;
      esac
      ;;
    generate)
      case $previous in
        --scene) values='uniform clusters area flight head-on crossing sphere-swap encounters' ;;
        --area) values='medellin' ;;
        --format) values='csv tsv npy bin csv.gz tsv.gz npy.gz bin.gz' ;;
        -o | --output) files=yes ;;
        --points | --size | --clusters | --sigma | --seed | --speed | --miss | --duration | --interval) return ;;
        *) options='--points --scene --size --clusters --sigma --area --seed --speed --miss --duration --interval --output --format --quiet --help --version' ;;
      esac
      ;;
    bench)
      case $previous in
        --points | --threads) return ;;
        *) options='--points --threads --json --quiet --help --version' ;;
      esac
      ;;
    help) values='detect predict replay watch advise guide follow simulate verify fleet report view plot export generate bench' ;;
  esac

  case $current in
    -*) [ -z "$options" ] || values=$options files='' ;;
  esac
  [ -n "$values$files" ] || values=$options
  # Words before files, where both may stand.
  if [ -z "$files" ] || { [ -n "$values" ] && compgen -W "$values" -- "$current" > /dev/null; }; then
    _beespace_offer -W "$values" -- "$current"
  else
    compopt -o filenames
    _beespace_offer -f -- "$current"
  fi
}
complete -F _beespace beespace
