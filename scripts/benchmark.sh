#!/usr/bin/env bash
# Measures volsurf against what a user would use instead, on this machine, and writes docs/benchmarks.md.
#
# In:  options for scripts/benchmark.py (--quick, --huge, --out FILE) and, by choice, the folder of the volumes
#      (default: build/benchmark/volumes). What is there already is not fetched or made again.
# Out: the table, and all single measurements in build/benchmark/results.json. Exit code 1 where a program fails, for
#      example because its regions are not volsurf's.
set -euo pipefail

usage() {
  cat <<'END'
usage: benchmark.sh [--quick] [--huge] [--out FILE] [DIR]

Builds volsurf and its benchmarks, fetches the real volumes and makes the phantoms into DIR, runs each program several
times in turn, and writes docs/benchmarks.md. The machine should do nothing else: a busy one gives figures of no worth.
  --quick     one run of each, to see whether all works
  --huge      also the 512^3 phantom mirrored to 1024^3; needs 16 GB of memory, and 5 minutes more
  --out FILE  instead of docs/benchmarks.md

It takes about 20 minutes, --quick 5; the first time 10 more, to build and to get the volumes (1 GB of disk).
END
}

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/benchmark

# make_phantom SIZE DIR
make_phantom() {
  local size=$1 file=$2/phantom-$1.nrrd program=$build/apps/volsurf-phantom/volsurf-phantom
  [[ -f $file ]] || "$program" --size "$size" --noise impulse:2% --type uint16 -o "$file"
}

main() {
  local options=() volumes=$build/volumes
  while [[ $# -gt 0 ]]; do
    case $1 in
      --help | -h) usage && return ;;
      --quick | --huge) options+=("$1") ;;
      --out)
        [[ $# -gt 1 ]] || { usage >&2; exit 2; }
        options+=("$1" "$(realpath -m "$2")")
        shift
        ;;
      -*) usage >&2; exit 2 ;;
      *) volumes=$1 ;;
    esac
    shift
  done
  mkdir -p "$volumes"
  volumes=$(cd "$volumes" && pwd)
  "$root/scripts/install_packages.sh" --test
  cd "$root"
  cmake --preset release -B "$build" -DVOLSURF_BUILD_TESTS=OFF -DVOLSURF_BUILD_BENCHMARKS=ON
  cmake --build "$build" --parallel --target volsurf_compute peer_benchmark stage_benchmark volsurf-phantom
  scripts/fetch_data.sh "$volumes"
  make_phantom 256 "$volumes"
  make_phantom 512 "$volumes"
  exec /usr/bin/python3 scripts/benchmark.py "${options[@]}" "$build" "$volumes"
}

main "$@"
