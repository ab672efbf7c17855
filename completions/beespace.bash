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
    _beespace_offer -W 'detect generate bench help --help --version' -- "$current"
    return
  fi

  local words=''
  case $subcommand:$previous in
    help:help) words='detect generate bench' ;;
    detect:--report) words='at-risk pairs neighbors counts nearest groups closest-pair' ;;
    detect:--crs) words='auto wgs84 metres' ;;
    detect:--format) words='auto text npy bin' ;;
    generate:--scene) words='uniform clusters area' ;;
    generate:--area) words='medellin' ;;
    generate:--format) words='csv tsv npy bin csv.gz tsv.gz npy.gz bin.gz' ;;
    *:--output | detect:--others)
      compopt -o filenames
      _beespace_offer -f -- "$current"
      return
      ;;
    detect:--threshold | detect:--columns | detect:--threads | detect:--max-results) return ;;
    bench:--points | bench:--threads) return ;;
    generate:--points | generate:--size | generate:--clusters | generate:--sigma | generate:--seed) return ;;
    *)
      case $subcommand in
        detect)
          words='--report --others --threshold --inclusive --at-risk-only --max-results --threads
            --crs --columns --format --skip-bad --output --csv --json --geojson --fail-on-risk
            --quiet --help --version'
          ;;
        generate)
          words='--scene --area --points --size --clusters --sigma --seed --format --output --quiet
            --help --version'
          ;;
        bench) words='--points --threads --json --quiet --help --version' ;;
      esac
      if [ "$subcommand" = detect ] && [[ "$current" != -* ]]; then
        compopt -o filenames
        _beespace_offer -f -- "$current"
        return
      fi
      ;;
  esac
  _beespace_offer -W "$words" -- "$current"
}
complete -F _beespace beespace
