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

subcommands=$("$command" --help | awk '/^Subcommands:/ {inside = 1; next} NF == 0 {inside = 0}
  inside && $1 != "help" {print $1}')
if [ "$(wc -w <<< "$subcommands")" -lt 13 ]; then
  echo "the help lists hardly any subcommands: $subcommands" >&2
  exit 1
fi

all=$(for subcommand in $subcommands; do
  options_in_help "$subcommand"
done | sort -u)
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

# What one subcommand takes must not hide that another one's completion lacks it; bash's can be asked.
offered_by_bash() {
  bash -c '
    source "$1"
    COMP_WORDS=(beespace "$2" --) COMP_CWORD=2
    _beespace
    printf "%s\n" "${COMPREPLY[@]}" | sort
  ' - "${completions[0]}" "$1"
}
for subcommand in $subcommands; do
  difference=$(diff <(options_in_help "$subcommand") <(offered_by_bash "$subcommand")) ||
    { echo "bash is offered other options of $subcommand than its help lists: $difference"; wrong=1; }
done

# The words that a help text lists under a heading, each at the beginning of a line. (Read to the
# end: the command reports a closed pipe.)
words_in_help() {
  "$command" "$1" --help | awk -v heading="^$2" '$0 ~ heading {inside = 1; next}
    NF == 0 {inside = 0} inside && /^  [a-z]/ {print $1}'
}

# words_are_named SUBCOMMAND HEADING AT_LEAST: every such word, in the manual and the completions.
words_are_named() {
  local words word text
  words=$(words_in_help "$1" "$2")
  if [ "$(wc -w <<< "$words")" -lt "$3" ]; then
    echo "the help of $1 lists hardly anything under $2: $words" >&2
    exit 1
  fi
  for word in $words; do
    for text in "$manual_text" "$(cat "${completions[0]}")" "$(cat "${completions[1]}")" \
      "$(cat "${completions[2]}")"; do
      grep -qE -- "(^|[^a-z-])$word([^a-z-]|$)" <<< "$text" ||
        { echo "the manual or a completion does not name $word, of $1"; wrong=1; }
    done
  done
}
words_are_named detect Reports 5
words_are_named replay Reports 4
words_are_named generate Scenes 8
words_are_named simulate Scenarios 3

# Events and advice are no words of the command line: the manual names them.
# words_are_explained SUBCOMMAND HEADING AT_LEAST
words_are_explained() {
  local words word
  words=$(words_in_help "$1" "$2")
  if [ "$(wc -w <<< "$words")" -lt "$3" ]; then
    echo "the help of $1 lists hardly anything under $2: $words" >&2
    exit 1
  fi
  for word in $words; do
    grep -qxF -- ".B $word" <<< "$manual_text" ||
      { echo "$man_page does not explain $word, of $1"; wrong=1; }
  done
}
words_are_explained watch Events 6
words_are_explained advise Advice 4

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
