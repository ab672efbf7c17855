#!/usr/bin/env bash
# Proves what scripts/install-packages does on each kind of machine, with stand-ins for the
# system's commands: what is installed, which user runs it, whether there is sudo.
#
#   install_packages_test.sh SOURCE_FOLDER
set -euo pipefail
source=$1
fakes=$(mktemp -d)
trap 'rm -rf "$fakes"' EXIT

fail() {
  echo "install_packages_test: $*" >&2
  printf '%s\n' "output: ${output:-}" >&2
  exit 1
}

fake() { # name, body
  printf '#!%s\n%s\n' "$BASH" "$2" > "$fakes/$1"
  chmod +x "$fakes/$1"
}

for tool in dirname env cat; do ln -s "$(command -v "$tool")" "$fakes/$tool"; done
fake apt-get 'echo "apt-get $*"; echo "apt-get $*" >> "${0%/*}/log"'
installs_of() { grep -c ' install ' "$fakes/log" 2> /dev/null || true; }

attempt() { # arguments of install-packages; sets output and status
  status=0
  rm -f "$fakes/log"
  output=$(PATH=$fakes BEESPACE_SKIP_PACKAGES='' "$BASH" "$source/scripts/install-packages" "$@" 2>&1) ||
    status=$?
}

everything='echo installed'
all_but_cmake='[ "${@: -1}" = cmake ] && exit 1; echo installed'

fake dpkg-query "$everything"
fake id 'echo 0'
attempt build test
[ "$status" = 0 ] && [ -z "$output" ] || fail "with everything installed it must be silent"

fake dpkg-query "$all_but_cmake"
attempt build
[ "$status" = 0 ] && [[ "$output" == *"missing packages: cmake"* ]] || fail "root: says what it installs"
grep -q -- 'install -y --no-install-recommends cmake$' "$fakes/log" || fail "root: installs only cmake"

fake id 'echo 1000'
attempt build
[ "$status" = 1 ] && [[ "$output" == *"apt-get install -y --no-install-recommends cmake"* ]] ||
  fail "without root and sudo it must say what to type"
[ "$(installs_of)" = '' ] || [ "$(installs_of)" = 0 ] || fail "without root and sudo it tried to install"

fake sudo 'echo "by sudo: $*"; exec "$@"'
attempt build
[ "$status" = 0 ] && [[ "$output" == *"by sudo: "*"install"*cmake* ]] || fail "sudo was not used"

fake apt-get '[[ "$*" == *update* ]]'
attempt build
[ "$status" = 1 ] && [[ "$output" == *"Could not install cmake"* ]] || fail "a failed install must fail"

rm "$fakes/dpkg-query"
attempt build
[ "$status" = 0 ] && [[ "$output" == *"not Debian"*cmake* ]] || fail "elsewhere: name them and go on"

attempt no-such-purpose
[ "$status" = 2 ] || fail "an unknown purpose must be refused"

# What a package is needed for, in a list of one's own. What the system is called cannot be faked.
mkdir -p "$fakes/project/scripts"
cp "$source/scripts/install-packages" "$fakes/project/scripts/"
source=$fakes/project
if grep -qx 'ID=debian' /etc/os-release 2> /dev/null; then here=' on-debian'; else here=''; fi
ln -s "$(command -v grep)" "$fakes/grep"
packages() { # lines of packages.txt; sets output to what is needed
  printf '%s\n' "$@" > "$source/scripts/packages.txt"
  attempt build
}
packages 'build always' 'build no-tool  unless=tool # unless=nothing' 'build on-debian on=debian' \
  'build neither unless=tool on=debian' 'test another'
all="always no-tool$here"
if [ -n "$here" ]; then all+=' neither'; fi
[ "$status" = 0 ] && [[ "$output" == *"what they call: $all"$'\n'* ]] || fail "needed are '$all'"

fake tool 'exit 1'
packages 'build always' 'build no-tool unless=tool' 'build on-debian on=debian' \
  'build neither unless=tool on=debian' 'build other unless=no-such-tool'
[ "$status" = 0 ] && [[ "$output" == *"what they call: always$here other"$'\n'* ]] ||
  fail "with the tool from elsewhere its package is not needed"

packages 'build always' 'build what when=ever'
[ "$status" = 2 ] && [[ "$output" == *"'when=ever' is no condition"* ]] ||
  fail "an unknown condition must be refused"

packages 'build no-tool unless=tool'
[ "$status" = 0 ] && [ -z "$output" ] || fail "with nothing needed it must be silent"
