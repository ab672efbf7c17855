# Which files belong to the project; sourced by the other scripts.
# shellcheck shell=bash

# All files of the project, each ended by a NUL: what git tracks and what is new and not ignored,
# or, in an unpacked archive, whatever is there besides the build.
project_files() {
  if git rev-parse --is-inside-work-tree > /dev/null 2>&1; then
    git ls-files -z --cached --others --exclude-standard |
      while IFS= read -r -d '' file; do
        if [ -f "$file" ]; then printf '%s\0' "$file"; fi
      done
  else
    find . \( -path ./build -o -path ./demo -o -path ./.git -o -name node_modules \
      -o -path ./web/dist \) -prune -o -type f -print0 |
      sed -z 's|^\./||'
  fi
}

# The files of C, each ended by a NUL.
c_files() {
  project_files | { grep -zE '\.(c|h)$' || true; } | LC_ALL=C sort -z
}

# The C++ files below the given folders (none: all of them), each ended by a NUL.
cpp_files() {
  local pattern='\.(cpp|hpp)$'
  if [ $# -gt 0 ]; then
    local folders
    folders=$(IFS='|'; echo "$*")
    pattern="^($folders)/.*$pattern"
  fi
  project_files | { grep -zE "$pattern" || true; } | LC_ALL=C sort -z
}
