#!/usr/bin/env bash
# Proves that the installed library can be used: installs it, moves the tree elsewhere, builds the
# quickstart example as a project of its own with find_package and with pkg-config, and runs both.
#
#   package_test.sh static|shared SOURCE_FOLDER BUILD_FOLDER COMPILER VERSION
set -euo pipefail

kind=$1 source=$2 build=$3 compiler=$4 version=$5
here=$source/tests/packaging
example=$source/examples/quickstart.cpp
expected='2 of 4 drones are at risk: 2 3'

work=$build/tests/packaging/$kind
rm -rf "$work/installed" "$work/moved" "$work/consumer" "$work/refused" "$work/with-pkg-config" "$work/both"
mkdir -p "$work"

fail() {
  echo "package_test ($kind): $*" >&2
  exit 1
}

if [ "$kind" = shared ]; then
  library_build=$work/build
  # What it exports is looked at, not how fast it is.
  cmake -S "$source" -B "$library_build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_FLAGS_RELEASE='-O0 -DNDEBUG' \
    -DCMAKE_CXX_COMPILER="$compiler" -DBUILD_SHARED_LIBS=ON -DBEESPACE_WERROR=ON \
    -DBEESPACE_BUILD_CLI=OFF -DBEESPACE_BUILD_TESTS=OFF -DBEESPACE_BUILD_EXAMPLES=OFF > /dev/null
  cmake --build "$library_build"
else
  library_build=$build
fi
cmake --install "$library_build" --prefix "$work/installed" > /dev/null
# Whatever still points to where it was installed first breaks now.
mv "$work/installed" "$work/moved"
prefix=$work/moved

configure_consumer() { # folder, wanted version, static or shared or nothing
  cmake -S "$here/consumer" -B "$1" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_PREFIX_PATH="$prefix" \
    -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF -DCONSUMER_SOURCE="$example" -DWANTED_VERSION="$2" \
    -DWANTED_KIND="${3:-}"
}

check_output() { # program and arguments
  local output
  output=$("$@")
  [ "$output" = "$expected" ] || fail "'$*' printed '$output', not '$expected'"
}

# find_package: this version is taken, the next minor version is refused (0.x may break users).
configure_consumer "$work/consumer" "$version" > /dev/null
cmake --build "$work/consumer"
check_output "$work/consumer/consumer"
next_minor=$(echo "$version" | awk -F. '{print $1 "." $2 + 1}')
if configure_consumer "$work/refused" "$next_minor" > "$work/refused.log" 2>&1; then
  fail "find_package(beespace $next_minor) accepted version $version"
fi
grep -q 'compatible with' "$work/refused.log" || fail "refused for another reason: $work/refused.log"

# pkg-config.
pc_folder=$(dirname "$(find "$prefix" -name beespace.pc)")
export PKG_CONFIG_PATH=$pc_folder
[ "$(pkg-config --modversion beespace)" = "$version" ] || fail "beespace.pc has another version"
read -ra flags <<< "$(pkg-config --cflags --libs beespace)"
"$compiler" -std=c++20 "$example" "${flags[@]}" -o "$work/with-pkg-config"
libraries=$(dirname "$pc_folder")
LD_LIBRARY_PATH=$libraries check_output "$work/with-pkg-config"

if [ "$kind" = shared ]; then
  # A static archive must not have been linked by mistake, and only beespace's own is exported.
  # (Not in a pipe to grep -q, which may end before ldd has written all.)
  used=$(LD_LIBRARY_PATH=$libraries ldd "$work/with-pkg-config")
  grep -q "$prefix.*libbeespace++.so" <<< "$used" ||
    fail "the program does not use the shared library"
  leaked=$(nm -D --defined-only "$libraries/libbeespace++.so" | awk '$2 !~ /^[VvWwu]$/ {print $3}' |
    grep -v beespace || true)
  [ -z "$leaked" ] || fail "the shared library exports names that are not beespace's: $leaked"
  exported=$(nm -D --defined-only -C "$libraries/libbeespace++.so")
  internals=$(grep -E 'beespace::(core|cpu|search|motion|geodesy|avoidance|verify)::' <<< "$exported" || true)
  [ -z "$internals" ] || fail "the shared library exports internals: $internals"
  grep -q 'beespace::find_at_risk' <<< "$exported" || fail "find_at_risk is not exported"

  # Side by side with a static one: each is found by its name.
  prefix=$work/both
  rm -rf "$prefix"
  for one in "$build" "$library_build"; do cmake --install "$one" --prefix "$prefix" > /dev/null; done
  export PKG_CONFIG_PATH=$prefix/${pc_folder#"$work/moved/"}
  libraries=$(dirname "$PKG_CONFIG_PATH")
  for wanted in static shared; do
    rm -rf "$work/consumer-$wanted"
    configure_consumer "$work/consumer-$wanted" "$version" "$wanted" > /dev/null
    cmake --build "$work/consumer-$wanted"
    read -ra flags <<< "$(pkg-config --cflags --libs "beespace-$wanted")"
    "$compiler" -std=c++20 "$example" "${flags[@]}" -o "$work/with-pkg-config-$wanted"
    for program in "$work/consumer-$wanted/consumer" "$work/with-pkg-config-$wanted"; do
      LD_LIBRARY_PATH=$libraries check_output "$program"
      used=$(LD_LIBRARY_PATH=$libraries ldd "$program")
      if grep -qF libbeespace++.so <<< "$used"; then uses=shared; else uses=static; fi
      [ "$uses" = "$wanted" ] || fail "$program uses the $uses library, not the $wanted one"
    done
  done
else
  # The library for C, whatever is beside it.
  read -ra flags <<< "$(pkg-config --cflags --libs beespace-c)"
  cc -std=c99 "$source/examples/pairs_in_c.c" "${flags[@]}" -o "$work/in-c"
  [ "$(LD_LIBRARY_PATH=$libraries "$work/in-c")" = '2 and 3 are 99.9 m apart' ] ||
    fail "the example in C prints something else"

  installed_version=$("$prefix/bin/beespace" --version)
  [[ "$installed_version" == *"$version"* ]] ||
    fail "the installed command says '$installed_version', not $version"
  for file in share/man/man1/beespace.1 share/bash-completion/completions/beespace \
    share/zsh/site-functions/_beespace share/fish/vendor_completions.d/beespace.fish; do
    [ -s "$prefix/$file" ] || fail "$file is not installed"
  done
fi

# The installed text must not name the folders it was built in.
if grep -rIlF -e "$source/" -e "$build/" "$prefix"; then
  fail "the files above name the folder they were built in"
fi
