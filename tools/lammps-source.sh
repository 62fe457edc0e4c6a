#!/bin/sh
# Prints the folder of the LAMMPS source; fetches it first if it is not in the cache.
# It is the source package of Debian 13, or with SPHTM_LAMMPS=20260704 that of Debian testing, taken from the mirror
# this machine's apt already uses, with a private source list and private state: the machine's own apt configuration
# stays as it is. SPHTM_LAMMPS_SOURCE=<folder> uses a LAMMPS source tree of your own instead.
set -eu
. "$(dirname -- "$0")/common.sh"

case $lammps in
  20250204)
    suite=trixie release='4 Feb 2025' version=20250204+dfsg.1 ending=tar.xz megabytes=132
    sha256=3671165bd52fad36734e0a9136c5bc5ecb225e03988f8c89aa13366a8b53b1c7 ;;
  20260704)
    suite=testing release='4 Jul 2026' version=20260704+dfsg ending=tar.gz megabytes=214
    sha256=cddbc45a047416bd48a4a0b87f24a5b61b3446982b74d18cafe619c22b17eb62 ;;
esac
tarball=lammps_$version.orig.$ending

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
  die "no apt-get here: unpack LAMMPS $release yourself and set SPHTM_LAMMPS_SOURCE to its folder"

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
  die "the source index of Debian $suite could not be fetched from $mirror$(cause_in "$work/log"). With a LAMMPS $release" \
    "of your own, set SPHTM_LAMMPS_SOURCE to its folder"
}
line=$(private apt-get -q source --print-uris --only-source lammps 2> "$work/log" | grep -F " $tarball ") ||
  { cat "$work/log" >&2; die "Debian $suite no longer has $tarball: set SPHTM_LAMMPS_SOURCE"; }
uri=$(echo "$line" | cut -d "'" -f 2)
[ "${line##* SHA256:}" = "$sha256" ] || die "the signed index gives another SHA256 for $tarball than expected"

say "downloading $tarball ($megabytes MB)"
private /usr/lib/apt/apt-helper download-file "$uri" "$work/$tarball" "SHA256:$sha256" > "$work/log" 2>&1 ||
  { cat "$work/log" >&2; die "$tarball could not be downloaded$(cause_in "$work/log")"; }
echo "$sha256  $work/$tarball" | sha256sum --check --quiet - >&2 || die "$tarball is damaged"

say "unpacking"
mkdir "$work/unpacked"
tar -xf "$work/$tarball" -C "$work/unpacked" \
  --exclude='examples/*' --exclude='bench/*' --exclude='doc/*' --exclude='tools/*' --exclude='potentials/*' \
  2> "$work/log" || { cat "$work/log" >&2; die "$tarball could not be unpacked$(cause_in "$work/log")"; }
tree=$work/unpacked    # some archives have a top folder, some do not
[ -f "$tree/src/version.h" ] || tree=$(echo "$tree"/*/)
[ -f "$tree/src/version.h" ] || die "$tarball has no src/version.h"
tree=${tree%/}
echo "${source##*/}" > "$tree/$mark"    # an archive's folder is never empty: make_folder would leave it without
mv "$tree" "$source"
echo "$source"
