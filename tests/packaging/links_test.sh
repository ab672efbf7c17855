#!/usr/bin/env bash
# Proves that what the documents link to is there: files, folders, and headings of documents.
#
#   links_test.sh SOURCE_FOLDER DOCUMENT...
set -euo pipefail
cd "$1"
shift

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# The anchors that a document has, as GitHub makes them of its headings.
anchors() {
  awk '/^```/ {inside = !inside} !inside && /^#+ / {sub(/^#+ /, ""); print}' "$1" |
    tr '[:upper:]' '[:lower:]' | sed -e 's/[^a-z0-9 _-]//g' -e 's/ /-/g'
}

failed=0
for document in "$@"; do
  # Links are in text, not in code.
  awk '/^```/ {inside = !inside; next} !inside {gsub(/`[^`]*`/, ""); print}' "$document" |
    grep -oE '\]\([^)]+\)' | sed -e 's/^](//' -e 's/)$//' > "$scratch/links" || true
  while IFS= read -r link; do
    case $link in *://* | mailto:*) continue ;; esac
    file=${link%%#*}
    target=$document
    if [ -n "$file" ]; then target=$(dirname "$document")/$file; fi
    if [ ! -e "$target" ]; then
      echo "$document: $link is not there" >&2
      failed=1
    elif [[ "$link" == *\#* ]] && ! anchors "$target" | grep -qx -- "${link#*#}"; then
      echo "$document: $file has no heading #${link#*#}" >&2
      failed=1
    fi
  done < "$scratch/links"
done
exit "$failed"
