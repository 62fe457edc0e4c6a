#!/bin/sh
# Prints the folder of the LAMMPS source; fetches it first if it is not in the cache.
# It is the source package of Debian 13, taken from the mirror this machine's apt already uses, with
# a private source list and private state: the machine's own apt configuration stays as it is.
# SPHTM_LAMMPS_SOURCE=<folder> uses a LAMMPS source tree of your own instead.
set -eu
. "$(dirname -- "$0")/common.sh"

suite=trixie
version=20250204+dfsg.1
sha256=3671165bd52fad36734e0a9136c5bc5ecb225e03988f8c89aa13366a8b53b1c7
tarball=lammps_$version.orig.tar.xz

if [ -n "${SPHTM_LAMMPS_SOURCE:-}" ]; then
  [ -f "$SPHTM_LAMMPS_SOURCE/src/version.h" ] || die "SPHTM_LAMMPS_SOURCE=$SPHTM_LAMMPS_SOURCE has no src/version.h"
  echo "$SPHTM_LAMMPS_SOURCE"; exit 0
fi

need_cache
source=$cache/lammps-$version
[ -f "$source/src/version.h" ] && { echo "$source"; exit 0; }
lock source
[ -f "$source/src/version.h" ] && { echo "$source"; exit 0; }
command -v apt-get > /dev/null ||
  die "no apt-get here: unpack LAMMPS 4 Feb 2025 yourself and set SPHTM_LAMMPS_SOURCE to its folder"

make_way "$source"
sweep "$cache"/unpack.*
need_space 1000 "LAMMPS's source"
work=$(mktemp -d "$cache/unpack.XXXXXX")
make_folder "$work"
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM

mirror=$(apt-get indextargets --format '$(ORIGIN)|$(LABEL)|$(COMPONENT)|$(IDENTIFIER)|$(REPO_URI)' |
         sed -n 's/^Debian|Debian|main|Packages|//p' | head -n 1)
[ -n "$mirror" ] || die "apt knows no Debian mirror on this machine: run apt-get update, or set SPHTM_LAMMPS_SOURCE"
keyring=/usr/share/keyrings/debian-archive-keyring.gpg
mkdir -p "$work/lists/partial" "$work/cache/archives/partial"
echo "deb-src [signed-by=$keyring] $mirror $suite main" > "$work/sources.list"
private() {
  tool=$1; shift
  "$tool" -o Dir::Etc::sourcelist="$work/sources.list" -o Dir::Etc::sourceparts=/dev/null \
    -o Dir::State="$work" -o Dir::State::lists="$work/lists" -o Dir::State::status=/dev/null \
    -o Dir::Cache="$work/cache" -o APT::Sandbox::User= "$@"
}

say "reading the source index of Debian $suite"
# an index that cannot be fetched is a warning to apt-get, unless told otherwise
private apt-get -q -o APT::Update::Error-Mode=any update > "$work/log" 2>&1 || {
  cat "$work/log" >&2
  die "the source index of Debian $suite could not be fetched from $mirror$(cause_in "$work/log"). With a LAMMPS 4 Feb 2025" \
    "of your own, set SPHTM_LAMMPS_SOURCE to its folder"
}
line=$(private apt-get -q source --print-uris --only-source lammps 2> "$work/log" | grep -F " $tarball ") ||
  { cat "$work/log" >&2; die "Debian $suite no longer has $tarball: set SPHTM_LAMMPS_SOURCE"; }
uri=$(echo "$line" | cut -d "'" -f 2)
[ "${line##* SHA256:}" = "$sha256" ] || die "the signed index gives another SHA256 for $tarball than expected"

say "downloading $tarball (132 MB)"
private /usr/lib/apt/apt-helper download-file "$uri" "$work/$tarball" "SHA256:$sha256" > "$work/log" 2>&1 ||
  { cat "$work/log" >&2; die "$tarball could not be downloaded$(cause_in "$work/log")"; }
echo "$sha256  $work/$tarball" | sha256sum --check --quiet - >&2 || die "$tarball is damaged"

say "unpacking"
make_folder "$work/tree" "${source##*/}"
tar -xJf "$work/$tarball" -C "$work/tree" --strip-components=1 \
  --exclude='*/examples/*' --exclude='*/bench/*' --exclude='*/doc/*' --exclude='*/tools/*' --exclude='*/potentials/*' \
  2> "$work/log" || { cat "$work/log" >&2; die "$tarball could not be unpacked$(cause_in "$work/log")"; }
mv "$work/tree" "$source"
echo "$source"
