#!/usr/bin/env bash
# Installs the Debian 12 packages that volsurf needs. This is the one list of them.
#
# In:  what they are needed for: building always, testing and rendering by choice (see --help).
# Out: the packages, by apt-get, as root or through sudo. Nothing is done, and no network needed, where they are all
#      installed. Exit code 1 where that fails.
set -euo pipefail

build_packages=(
  g++ cmake ninja-build
  libvtk9-dev libinsighttoolkit5-dev libopenvdb-dev libboost-iostreams-dev libimath-dev
  libvtkgdcm-tools libgdcm-tools # GDCM's CMake targets name their programs
  libtbb-dev libcli11-dev nlohmann-json3-dev libssl-dev zlib1g-dev
  libcairo2-dev pkgconf fonts-dejavu-core # charts, and the letters in them
)
test_packages=(
  libgtest-dev librapidcheck-dev libgudhi-dev libboost-dev libbenchmark-dev
  libopenvdb-tools python3 python3-jsonschema
  clang-format clang-tidy git
)
cgal_packages=(libcgal-dev) # brings GMP and MPFR
render_packages=(python3-vtk9 xvfb xauth libgl1-mesa-dri) # without the last, Xvfb has no GLX

usage() {
  cat <<'END'
usage: install_packages.sh [--test] [--render] [--cgal] [--list]

Installs the Debian packages that building volsurf needs.
  --test    also those of its tests
  --render  also those of scripts/render.py (python3-vtk9 and a virtual display)
  --cgal    also those of VOLSURF_WITH_CGAL
  --list    prints the packages, installs nothing

ParaView, for paraview/view.py, is not among them: Debian's python3-paraview conflicts with python3-vtk9, which
libvtk9-dev needs, so that it has to be on another machine or in a container.
END
}

fail() {
  printf 'install_packages.sh: %s\n' "$*" >&2
  exit 1
}

# missing PACKAGE...: prints those that are not installed.
missing() {
  local package
  for package in "$@"; do
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || printf '%s\n' "$package"
  done
}

as_root() {
  if [[ $EUID -eq 0 ]]; then
    "$@"
  else
    sudo "$@"
  fi
}

apt() { as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0 "$@"; }

# install PACKAGE...: the log is shown only where that fails.
install() {
  local log
  [[ $EUID -eq 0 ]] || command -v sudo >/dev/null ||
    fail "these packages are missing, and installing them needs root or sudo: $*"
  log=$(mktemp)
  echo "installing $# Debian packages and what they need: $*"
  if ! { apt update && apt install -y --no-install-recommends "$@"; } >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    rm "$log"
    fail "apt-get failed, see above"
  fi
  rm "$log"
  echo "installed"
}

main() {
  local wanted=("${build_packages[@]}") list_only=no argument
  for argument in "$@"; do
    case $argument in
      --test) wanted+=("${test_packages[@]}") ;;
      --render) wanted+=("${render_packages[@]}") ;;
      --cgal) wanted+=("${cgal_packages[@]}") ;;
      --list) list_only=yes ;;
      --help | -h) usage && return ;;
      *) usage >&2 && exit 2 ;;
    esac
  done
  if [[ $list_only == yes ]]; then
    printf '%s\n' "${wanted[@]}" | sort -u
    return
  fi
  command -v apt-get >/dev/null || fail "there is no apt-get here; volsurf is built on Debian 12"
  local absent
  mapfile -t absent < <(missing "${wanted[@]}")
  if [[ ${#absent[@]} -gt 0 ]]; then
    install "${absent[@]}"
  fi
}

main "$@"
