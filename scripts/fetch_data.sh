#!/usr/bin/env bash
# Gets real volumes to try volsurf on, out of Debian packages that are downloaded and unpacked but not installed.
#
# In:  the folder to put them into.
# Out: ch2.nii.gz, ch2bet.nii.gz, ch2better.nii.gz (MR heads), cranium.nhdr + .raw (CT head), liver.nhdr + .inr
#      (labels), skull.nhdr + .inr (a small scalar field), and README.md, which says where each comes from.
# What is there already, with the right SHA-256, is left alone. Exit code 1 where something cannot be had.
set -euo pipefail

usage() {
  cat <<'END'
usage: fetch_data.sh DIR

Downloads the Debian packages mricron-data, invesalius-examples and libcgal-demo (59 MB, nothing is installed)
and puts the medical volumes in them into DIR: ch2.nii.gz, ch2bet.nii.gz, ch2better.nii.gz, cranium.nhdr,
liver.nhdr, skull.nhdr and README.md. Needs about 60 MB in DIR, and 250 MB in TMPDIR while it runs. Volumes that are
in DIR already are not fetched again.
END
}

say() { printf '%s\n' "$*"; }

fail() {
  printf 'fetch_data.sh: %s\n' "$*" >&2
  exit 1
}

# has_checksum FILE SHA256
has_checksum() { [[ -f $1 ]] && printf '%s  %s\n' "$2" "$1" | sha256sum --check --status; }

update_package_lists() {
  say "package lists: updating, because they are missing" >&2
  apt-get -qq update || fail "apt-get update failed; is the network there?"
}

# know_package PACKAGE: makes sure that apt's package lists have it.
know_package() {
  apt-cache show "$1" >/dev/null 2>&1 && return
  [[ $EUID -eq 0 ]] || fail "package $1 is not in apt's package lists: run 'sudo apt-get update' and try again"
  update_package_lists
  apt-cache show "$1" >/dev/null 2>&1 || fail "package $1 is in none of the package sources of this machine"
}

# unpack PACKAGE: downloads a package and unpacks it into $work/PACKAGE, once.
unpack() {
  [[ -d $work/$1 ]] && return
  know_package "$1"
  mkdir "$work/$1.deb"
  (cd "$work/$1.deb" && apt-get -qq -o APT::Sandbox::User=root download "$1") >"$work/$1.log" 2>&1 ||
    fail "cannot fetch package $1: $(tail -n 1 "$work/$1.log")"
  dpkg-deb -x "$work/$1.deb"/*.deb "$work/$1" || fail "cannot unpack package $1"
}

# The next four print a volume's bytes.
mricron_volume() {
  unpack mricron-data
  cat "$work/mricron-data/usr/share/mricron/templates/$1"
}

invesalius_matrix() {
  unpack invesalius-examples
  tar -xzOf "$work/invesalius-examples/usr/share/doc/invesalius-examples/examples/Cranium.inv3" \
    --wildcards '*/matrix.dat'
}

cgal_image() {
  unpack libcgal-demo
  tar -xzOf "$work/libcgal-demo/usr/share/doc/libcgal-dev/data.tar.gz" "data/images/$1"
}

cgal_zipped_image() { cgal_image "$1" | gzip -dc; }

# put FILE SHA256 COMMAND...: makes DIR/FILE of what COMMAND prints, unless it is there.
put() {
  local file=$1 checksum=$2
  shift 2
  if has_checksum "$target/$file" "$checksum"; then
    say "$file: is there already"
    return
  fi
  "$@" >"$work/volume" || fail "$file: cannot be taken out of its package"
  has_checksum "$work/volume" "$checksum" ||
    fail "$file: has SHA-256 $(sha256sum <"$work/volume" | cut -d' ' -f1), expected $checksum"
  install -m 644 "$work/volume" "$target/$file" || fail "$file: cannot be written into $target"
  say "$file: fetched"
}

# put_header NAME DATA TYPE SIZES DIRECTIONS SKIP: makes DIR/NAME.nhdr, a NRRD header that reads DATA in place.
put_header() {
  cat >"$target/$1.nhdr" <<END || fail "$1.nhdr: cannot be written into $target"
NRRD0004
# Made by volsurf's scripts/fetch_data.sh; README.md says where the data come from.
type: $3
dimension: 3
space: left-posterior-superior
sizes: $4
space directions: $5
space origin: (0,0,0)
kinds: domain domain domain
endian: little
encoding: raw
byte skip: $6
data file: $2
END
}

put_mr_heads() {
  put ch2.nii.gz a009051127f64dc3dd554d5f5b589870ea72106d9642c21b4e7093e478cfc309 mricron_volume ch2.nii.gz
  put ch2bet.nii.gz 592a2d20abdf36eefcb540ca8958428040edffc1bc1a18ba1dcfbabac77c5dd1 mricron_volume ch2bet.nii.gz
  put ch2better.nii.gz a094f3ccf383c495c9569625bd0c06993fd4b02d2a8d9966da5fea7d7e530e8d \
    mricron_volume ch2better.nii.gz
}

# InVesalius turns each slice of a scan upside down, as its picture has the front of the head at the high end of the
# second axis: the frame is left-handed.
put_ct_head() {
  put cranium.raw d87fd5e6aaf2c4fdf4f3fe28ee3335192fc2464ed8e9682fc78530cb837938da invesalius_matrix
  put_header cranium cranium.raw int16 "256 256 108" "(0.957031,0,0) (0,-0.957031,0) (0,0,1.5)" 0
}

# An INRIMAGE file has a header of 256 bytes.
put_cgal_images() {
  put liver.inr a0b09cf854bfb5bad38fdf3a03f1b9a64a9e8b4f6ea4da14932eb137bd7eea63 cgal_zipped_image liver.inr.gz
  put_header liver liver.inr uint8 "438 353 165" "(0.617188,0,0) (0,0.617188,0) (0,0,1.33333)" 256
  put skull.inr 7a9147c819e426fbd7bf4f0ed5ddac799e54376f64260ef4f650f29e3aa5d4c4 cgal_image skull_2.9.inr
  put_header skull skull.inr float "64 64 64" "(3.94305,0,0) (0,3.94305,0) (0,0,3.65079)" 256
}

put_readme() {
  cat >"$target/README.md" <<'END' || fail "README.md: cannot be written into $target"
# Where these volumes come from

`scripts/fetch_data.sh` took them out of packages of Debian 12. Their licences are those that each package's
`/usr/share/doc/PACKAGE/copyright` gives for its files.

| file | what | package, file in it | licence |
|---|---|---|---|
| ch2.nii.gz | MR head, T1, 181 x 217 x 181, 1 mm | mricron-data, templates/ch2.nii.gz | BSD-3-clause (Chris Rorden) |
| ch2bet.nii.gz | the same, brain only | mricron-data, templates/ch2bet.nii.gz | BSD-3-clause |
| ch2better.nii.gz | MR brain, 301 x 370 x 316, 0.5 mm | mricron-data, templates/ch2better.nii.gz | BSD-3-clause |
| cranium.nhdr, .raw | CT head, 256 x 256 x 108, 0.957 x 0.957 x 1.5 mm | invesalius-examples, Cranium.inv3 | GPL-2 (CTI Renato Archer) |
| liver.nhdr, .inr | labels: liver 255, kidney 127, gall bladder 84 and 85; 438 x 353 x 165 | libcgal-demo, images/liver.inr.gz | CC0 1.0 |
| skull.nhdr, .inr | blurred skull, 64 x 64 x 64 float | libcgal-demo, images/skull_2.9.inr | CC0 1.0 |

CGAL's copyright file (package libcgal-dev) puts every file without a notice of its own, as these two, under CC0 1.0.

The NIfTI files say how they lie in the patient. For the others the headers here say it, as far as the anatomy shows it:
front, back, top and bottom are sure in all three, and the liver's left and right; left and right of skull and cranium
are assumed (for cranium, that InVesalius turned each slice upside down, so that the frame is left-handed). Their
origins are not known and are 0.
END
}

main() {
  if [[ ${1-} == --help || ${1-} == -h ]]; then
    usage
    return
  fi
  [[ $# -eq 1 && $1 != -* ]] || { usage >&2; exit 2; }
  command -v apt-get >/dev/null || fail "there is no apt-get here; the volumes come from packages of Debian 12"
  mkdir -p "$1" || fail "cannot make the folder $1"
  target=$(cd "$1" && pwd)
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  put_mr_heads
  put_ct_head
  put_cgal_images
  put_readme
  say "the volumes are in $target, README.md there says where they come from"
}

main "$@"
