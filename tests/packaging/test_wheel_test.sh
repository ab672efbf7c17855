#!/usr/bin/env bash
# Proves that scripts/test-wheel tests each Python that it is given, with a line for each, and fails where
# one fails: with stand-ins for the Pythons, whose tests pass or not.
#
#   test_wheel_test.sh SOURCE_FOLDER
set -euo pipefail
source=$1
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
tree=$(realpath "$tree")

fail() {
  echo "test_wheel_test: $*" >&2
  printf '%s\n' "output: ${output:-}" >&2
  exit 1
}

# A clone with a wheel, as far as the script looks at it.
mkdir -p "$tree"/{build/wheel,docs,examples,python/{compare,requirements,tests},scripts,tests/cli}
cp "$source/scripts/test-wheel" "$tree/scripts/"
touch "$tree"/{README.md,build/wheel/beespace-0-py3-none-any.whl}
touch "$tree"/python/{README.md,conftest.py,requirements/test.txt}

python() { # name, version, what its tests end with
  cat > "$tree/$1" << END
#!$BASH
case "\$*" in
  *-m\ venv*)
    mkdir -p "\${@: -1}/bin"
    cp "\$0" "\${@: -1}/bin/python"
    printf '#!$BASH\n' > "\${@: -1}/bin/pip"
    chmod +x "\${@: -1}/bin/pip" ;;
  *beespace.__path__*) echo "\$(dirname "\$(dirname "\$0")")/lib/beespace" ;;
  *version_info*) [ -z "$2" ] || echo "$2" ;;
  *pytest*) exit $3 ;;
esac
END
  chmod +x "$tree/$1"
}
python good 3.11 0
python bad 3.12 1
python new 3.13 0
python old '' 0

attempt() { # Pythons; sets output and status
  status=0
  output=$("$tree/scripts/test-wheel" "${@/#/$tree/}" 2>&1) || status=$?
}

attempt good new
[ "$status" = 0 ] || fail "two that pass must pass"
for line in 'passed: Python 3.11' 'passed: Python 3.13'; do
  [[ "$output" == *"$line"* ]] || fail "there is no line '$line'"
done

attempt bad good new
[ "$status" = 1 ] || fail "one that fails must fail"
for line in "FAILED: Python 3.12, $tree/bad" 'passed: Python 3.11' 'passed: Python 3.13'; do
  [[ "$output" == *"$line"* ]] || fail "after one that fails there is no line '$line'"
done

for named in none old; do
  attempt "$named" good
  [ "$status" = 1 ] && [[ "$output" == *"FAILED: $tree/$named does not run, or is older"* ]] ||
    fail "one that is named and cannot be tested must fail"
  [[ "$output" == *'passed: Python 3.11'* ]] || fail "the other must be tested all the same"
done
