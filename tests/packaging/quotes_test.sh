#!/usr/bin/env bash
# Proves that the C++, C and Lua in the documents are those of examples/, which are compiled or run, and
# that the programs print what the documents say.
#
#   quotes_test.sh SOURCE_FOLDER PROGRAM_FOLDER DOCUMENT...
#
# What a fenced block shows is said in the line before it:
#   <!-- examples/NAME.cpp -->            the whole file
#   <!-- part of examples/NAME.cpp -->    lines of it, one behind the other; their indentation, as
#                                         far as they share it, is left out
#   <!-- output of NAME -->               what the program prints
# Each example is quoted somewhere, and its output as well.
set -euo pipefail
source=$1 programs=$2
shift 2

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# The quotes of a document as files: NUMBER.marker and NUMBER.quoted.
extract() {
  awk -v into="$2" '
    !inside && /^<!-- (part of |output of )?[A-Za-z0-9_\/.]+ -->$/ {
      marker = substr($0, 6, length($0) - 9)
      marked_at = NR
      next
    }
    /^```/ && !inside {
      inside = 1
      if (marked_at != NR - 1 || marker == "") {file = ""; next}
      file = into "/" sprintf("%03d", ++count)
      print marker > (file ".marker")
      close(file ".marker")
      printf "" > (file ".quoted")
      next
    }
    /^```/ {inside = 0; if (file != "") close(file ".quoted"); next}
    inside && file != "" {print > (file ".quoted")}
  ' "$1"
}

# Whether the lines of the first file are in the second one, one behind the other, all indented by
# the same number of blanks more, or none.
is_part_of() {
  awk '
    FNR == NR {quoted[++shown] = $0; next}
    {lines[++count] = $0}
    function matches(at, margin,   i, line) {
      for (i = 1; i <= shown; ++i) {
        line = lines[at + i - 1]
        if (quoted[i] == "" && line == "") continue
        if (line != margin quoted[i]) return 0
      }
      return 1
    }
    END {
      for (at = 1; at + shown - 1 <= count; ++at) {
        margin = lines[at]
        sub(/[^ ].*/, "", margin)
        own = quoted[1]
        sub(/[^ ].*/, "", own)
        if (length(own) <= length(margin) && matches(at, substr(margin, length(own) + 1))) exit 0
      }
      exit 1
    }
  ' "$1" "$2"
}

fail() {
  echo "$1" >&2
  failed=1
}

failed=0
for document in "$@"; do
  folder=$scratch/${document//\//_}
  mkdir "$folder"
  extract "$source/$document" "$folder"
  for marker in "$folder"/*.marker; do
    [ -f "$marker" ] || continue
    quoted=${marker%.marker}.quoted
    text=$(cat "$marker")
    [ -s "$quoted" ] || fail "$document: there is nothing behind <!-- $text -->"
    printf '%s\n' "$text" >> "$scratch/all"
    case $text in
      "output of "*)
        # Programs in C and Lua are run by tests in tests/c, with the shared library.
        if [ -f "$source/examples/${text#output of }.c" ]; then continue; fi
        if [ -f "$source/examples/${text#output of }.lua" ]; then continue; fi
        "$programs/${text#output of }" > "$scratch/printed" ||
          fail "$document: ${text#output of } ends with an error"
        diff "$quoted" "$scratch/printed" ||
          fail "$document: ${text#output of } prints something else, see above"
        ;;
      "part of "*)
        is_part_of "$quoted" "$source/${text#part of }" ||
          { cat "$quoted"; fail "$document: this is not in ${text#part of }"; }
        ;;
      *)
        diff "$quoted" "$source/$text" || fail "$document and $text differ, see above"
        ;;
    esac
  done
done

for example in "$source"/examples/*.cpp "$source"/examples/*.c "$source"/examples/*.lua; do
  name=$(basename "${example%.*}")
  grep -qE "^(part of )?examples/$name\.(cpp|c|lua)$" "$scratch/all" ||
    fail "no document quotes ${example##*/}"
  grep -qx "output of $name" "$scratch/all" || fail "no document shows what $name prints"
done
exit "$failed"
