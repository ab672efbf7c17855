#!/usr/bin/env bash
# Proves that every place that states the version states the same one.
#
#   versions_test.sh SOURCE_FOLDER VERSION [COMMAND]
set -euo pipefail
source=$1 version=$2 command=${3:-}

fail() {
  echo "versions_test: $*" >&2
  exit 1
}

header=$source/include/beespace/version.hpp
number() {
  awk -v name="BEESPACE_VERSION_$1" '$2 == name {print $3}' "$header"
}
parts="$(number MAJOR).$(number MINOR).$(number PATCH)"
[ "$parts" = "$version" ] || fail "version.hpp: the numbers say $parts, the text says $version"
grep -qF "## [$version]" "$source/CHANGELOG.md" || fail "CHANGELOG.md has no section [$version]"
grep -qE "^\.TH BEESPACE 1 .*\"beespace $version\"" "$source/man/beespace.1" ||
  fail "man/beespace.1 does not say beespace $version"
if [ -n "$command" ]; then
  said=$("$command" --version)
  [[ "$said" == *"$version"* ]] || fail "beespace --version says '$said', not $version"
fi
