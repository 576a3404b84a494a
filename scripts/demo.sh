#!/usr/bin/env bash
# Builds volsurf and runs its main job on data/brain.nrrd, from nothing but a clone and Debian 12.
#
# In:  nothing. May be run from any folder, as root or as a user who may use sudo (for the packages only).
# Out: build/demo/brain.vtp and its picture, build/demo/brain.png. Their names are the last lines of the output.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
result=$root/build/demo

build() {
  cmake --preset release -DVOLSURF_BUILD_TESTS=OFF
  cmake --build --preset release --parallel --target volsurf-cli
}

extract() {
  mkdir -p "$result"
  "$root/build/release/apps/volsurf/volsurf" "$root/data/brain.nrrd" --delta 20 --keep 5% -o "$result/brain.vtp"
}

draw() {
  "$root/scripts/render.py" "$result/brain.vtp" --png "$result/brain.png" --color Persistence
}

"$root/scripts/install_packages.sh" --render
cd "$root"
build
extract
draw
echo "surface: $result/brain.vtp"
echo "picture: $result/brain.png"
