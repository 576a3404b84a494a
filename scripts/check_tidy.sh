#!/usr/bin/env bash
# Checks the sources of src and apps with clang-tidy, by .clang-tidy.
#
# In:  the build folder, which holds compile_commands.json (default: build/release), then files (default: all .cpp files
#      of src and apps that this build compiles, and so the headers that they include).
# Out: clang-tidy's complaints, and exit code 1 if there are any.
set -euo pipefail

fail() {
  printf 'check_tidy.sh: %s\n' "$*" >&2
  exit 2
}

# tidy BUILD FILE...: prints what clang-tidy says, with as many processes as there are cores.
tidy() {
  local build=$1
  shift
  printf '%s\0' "$@" | xargs -0 -n 1 -P "$(nproc)" clang-tidy --quiet -p "$build" 2>&1
}

# compiled BUILD: the sources of src and apps that are part of a build.
compiled() {
  local file
  find src apps -name '*.cpp' | sort | while read -r file; do
    ! grep -q -F "/$file\"" "$1/compile_commands.json" || printf '%s\n' "$file"
  done
}

# ITK's headers, as Debian configured them, know no compiler but g++ and say so once per file, to no other effect; and
# clang-tidy counts the warnings that it does not show.
without_noise() {
  grep -v -E -e 'ITK.*Unsupported compiler' -e '^ *# *error Unsupported compiler' -e '^ *\^$' -e '^$' \
    -e '^[0-9]+ (warnings?|errors?)( and [0-9]+ errors?)? (treated|generated)' -e '^Error while processing'
}

main() {
  cd "$(dirname "${BASH_SOURCE[0]}")/.."
  local build=${1:-build/release} files=("${@:2}") complaints
  command -v clang-tidy >/dev/null || fail "there is no clang-tidy: run scripts/install_packages.sh --test"
  [[ -f $build/compile_commands.json ]] || fail "$build holds no compile_commands.json: configure it first"
  [[ ${#files[@]} -gt 0 ]] || mapfile -t files < <(compiled "$build")
  complaints=$(tidy "$build" "${files[@]}" | without_noise) || true
  if [[ -n $complaints ]]; then
    printf '%s\n' "$complaints"
    return 1
  fi
  echo "clang-tidy: ${#files[@]} files are clean"
}

main "$@"
