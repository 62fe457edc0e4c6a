#!/bin/sh
# Prints the path of a .deb with the plugin, the LAMMPS it is for, the command sphtm and the data; builds it in out/package.
# It is for the Debian it is built on. To look at one: dpkg-deb --contents, dpkg-deb --info.
set -eu
. "$(dirname -- "$0")/common.sh"

"$root/tools/packages.sh" package
command -v dpkg-shlibdeps > /dev/null ||
  die "a .deb needs dpkg-shlibdeps (of dpkg-dev); elsewhere cmake --install makes a tree to pack by other means"
host=$("$root/tools/host-plain.sh")
build=$("$root/tools/build-plugin.sh" "$host")
mkdir -p "$root/build"
work=$(mktemp -d "$root/build/packing.XXXXXX")
make_folder "$work"
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
[ -f "$root/out/manual/index.html" ] || say "without the manual as HTML: ./sphtm manual makes it"
say "packing"
(umask 022; cd "$work" && cpack -G DEB --config "$build/CPackConfig.cmake" -B "$work") > "$work/log" 2>&1 ||
  { cat "$work/log" >&2; die "cpack failed$(cause_in "$work/log")"; }
SPHTM_OUT=$root/out/package
make_folder "$SPHTM_OUT"
file=$(basename -- "$work"/*.deb)
mv "$work/$file" "$SPHTM_OUT/$file"
say "install it with: apt-get install $SPHTM_OUT/$file"
echo "$SPHTM_OUT/$file"
