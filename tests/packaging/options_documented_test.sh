#!/usr/bin/env bash
# Proves that the manual page and the completions name every option of every subcommand, and no
# option that is not there.
#
#   options_documented_test.sh SOURCE_FOLDER COMMAND
set -euo pipefail
source=$1 command=$2

man_page=$source/man/beespace.1
completions=("$source/completions/beespace.bash" "$source/completions/_beespace"
  "$source/completions/beespace.fish")
wrong=0

# A manual page writes a hyphen that can be copied as \-.
manual_text=$(sed 's/\\-/-/g' "$man_page")

# The long options that a help text lists: "  -t,--threshold FLOAT  ..." gives --threshold.
options_in_help() {
  "$command" "$@" --help | grep -E '^ +-' | grep -oE -- '--[a-z][a-z-]*' | sort -u
}

all=$(for subcommand in detect generate bench; do options_in_help "$subcommand"; done | sort -u)
if [ "$(wc -l <<< "$all")" -lt 10 ]; then
  echo "the help lists hardly any options: $all" >&2
  exit 1
fi

for option in $all; do
  name=${option#--}
  grep -qE -- "$option([^a-z-]|$)" <<< "$manual_text" ||
    { echo "$man_page does not name $option"; wrong=1; }
  for file in "${completions[@]}"; do
    # fish writes -l threshold.
    grep -qE -- "(--|-l )$name([^a-z-]|$)" "$file" || { echo "$file does not name $option"; wrong=1; }
  done
done

# What --report takes, as the help lists it.
reports=$("$command" detect --help | awk '/^Reports/ {inside = 1; next} inside && NF == 0 {exit} inside {print $1}')
if [ "$(wc -w <<< "$reports")" -lt 5 ]; then
  echo "the help lists hardly any reports: $reports" >&2
  exit 1
fi
for report in $reports; do
  for text in "$manual_text" "$(cat "${completions[0]}")" "$(cat "${completions[1]}")" \
    "$(cat "${completions[2]}")"; do
    grep -qE -- "(^|[^a-z-])$report([^a-z-]|$)" <<< "$text" ||
      { echo "the manual or a completion does not name the report $report"; wrong=1; }
  done
done

named=$(
  {
    grep -oE -- '--[a-z][a-z-]*' <<< "$manual_text"
    grep -ohE -- '--[a-z][a-z-]*' "${completions[@]:0:2}"
    grep -oE -- ' -l [a-z][a-z-]*' "${completions[2]}" | sed 's/ -l /--/'
  } | sort -u
)
for option in $named; do
  grep -qxF -- "$option" <<< "$all
--version
--help" || { echo "$option is documented, and the command does not have it"; wrong=1; }
done
exit "$wrong"
