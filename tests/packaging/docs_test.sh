#!/usr/bin/env bash
# Runs the commands of a document as a reader would, and compares what they print with what the
# document shows.
#
#   docs_test.sh SOURCE_FOLDER COMMAND DOCUMENT...
#
# A fenced block with a line that begins with "$ " is a session: each such line is a command (which
# goes on behind a backslash), and the lines below it are what it prints, standard output and
# standard error together. All sessions of a document run in one shell and one temporary folder, in
# which examples/ is that of the project and `beespace`, also as build/release/beespace, is COMMAND.
#
# A command must end with 0, unless the next one of its session is `echo $?`. A line "..." stands for
# any number of lines. A command below which nothing is shown may print what it likes. Times and
# rates are not compared, nor the size of a page that was written and its folder; numbers with more than six
# decimals are compared to six.
set -uo pipefail
source=$1 program=$2
shift 2
source=$(cd "$source" && pwd)
program=$(cd "$(dirname "$program")" && pwd)/$(basename "$program")

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0

# The sessions of a document as numbered files: NUMBER.line (where the command stands),
# NUMBER.command, NUMBER.expected, and NUMBER.status where the exit status is shown next.
extract() {
  awk -v into="$2" '
    function finish() {
      if (number == "") return
      close(file ".command"); close(file ".expected")
      number = ""
    }
    /^```/ {inside = !inside; finish(); session = 0; going_on = 0; next}
    !inside {next}
    going_on || /^\$ / {
      command = going_on ? $0 : substr($0, 3)
      if (!going_on) {
        if (session && command == "echo $?") printf "" > (file ".status")
        finish()
        number = sprintf("%04d", ++count)
        file = into "/" number
        print NR > (file ".line")
        close(file ".line")
        printf "" > (file ".expected")
        session = 1
      }
      going_on = command ~ /\\$/
      print command > (file ".command")
      next
    }
    session {print > (file ".expected")}
  ' "$1"
}

# What differs from run to run, or by a rounding: the same in what is shown and in what is printed.
comparable() {
  awk '
    function short(line,   out, number) {
      out = ""
      while (match(line, /-?[0-9]+\.[0-9][0-9][0-9][0-9][0-9][0-9][0-9]+(e[-+]?[0-9]+)?/)) {
        number = sprintf("%.6f", substr(line, RSTART, RLENGTH) + 0)
        if (number + 0 == 0) number = "0"
        out = out substr(line, 1, RSTART - 1) number
        line = substr(line, RSTART + RLENGTH)
      }
      return out line
    }
    /^  time  / || /^  flown  .* advice / {
      gsub(/[0-9][0-9.,]* (ns|us|ms|s|min)/, "TIME")
      gsub(/[0-9][0-9.,]* points\/s/, "RATE")
    }
    /^  written  / {gsub(/[0-9][0-9.,]* [kM]?B/, "SIZE")}
    /^  worst pair / {sub(/file:\/\/[^#]*\//, "file:///FOLDER/")}
    {print short($0)}
  ' "$1"
}

# Whether the lines of the second file are those of the first, in which "..." stands for any.
agrees() {
  awk '
    FNR == NR {expected[++shown] = $0; next}
    {printed[++count] = $0}
    # The pattern from line i on against what was printed from line k on: the shortest gap that fits.
    END {
      i = 1; k = 1; gap = 0; gap_at = 0
      while (k <= count) {
        if (i <= shown && expected[i] == "...") {gap = ++i; gap_at = k}
        else if (i <= shown && expected[i] == printed[k]) {++i; ++k}
        else if (gap) {i = gap; k = ++gap_at}
        else exit 1
      }
      while (i <= shown && expected[i] == "...") ++i
      exit i <= shown
    }
  ' "$1" "$2"
}

check_document() {
  local document=$1 name folder steps step line command status=0
  name=${document//\//_}
  steps=$scratch/$name.steps
  folder=$scratch/$name.folder
  mkdir -p "$steps" "$folder/build/release"
  cp -R "$source/examples" "$folder/examples"
  chmod -R u+w "$folder/examples"
  ln -s "$program" "$folder/build/release/beespace"
  extract "$source/$document" "$steps"
  cd "$folder" || return 1
  PATH=$folder/build/release:$PATH
  # As in a reader's shell: what a command before a pipe ends with does not count.
  set +o pipefail
  for step in "$steps"/*.command; do
    if [ ! -f "$step" ]; then
      echo "$document has no session" >&2
      return 1
    fi
    step=${step%.command}
    line=$(cat "$step.line")
    command=$(cat "$step.command")
    (exit "$status") # so that the command sees $? of the one before
    eval "$command" > "$step.printed" 2>&1 < /dev/null
    status=$?
    if [ "$status" != 0 ] && [ ! -f "$step.status" ]; then
      printf '%s:%s: exit status %s: %s\n' "$document" "$line" "$status" "$command" >&2
      cat "$step.printed" >&2
      return 1
    fi
    [ -s "$step.expected" ] || [ -f "$step.status" ] || continue
    comparable "$step.expected" > "$step.expected.comparable"
    comparable "$step.printed" > "$step.printed.comparable"
    if ! agrees "$step.expected.comparable" "$step.printed.comparable"; then
      printf '%s:%s: prints something else than the document says: %s\n' "$document" "$line" \
        "$command" >&2
      diff "$step.expected" "$step.printed" >&2
      echo >&2
      # The sessions behind it are looked at as well.
      touch "$scratch/$name.differs"
    fi
  done
  [ ! -f "$scratch/$name.differs" ]
}

for document in "$@"; do
  (check_document "$document") || failures=$((failures + 1))
done
if [ "$failures" != 0 ]; then
  echo "$failures of $# documents do not say what the command does, see above" >&2
  exit 1
fi
