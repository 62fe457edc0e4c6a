#!/bin/sh
# Prints the path of a .deb with the plugin, the LAMMPS it is for, the command sphtm and the data; builds it in out/package.
# It is for the Debian it is built on. To look at one: dpkg-deb --contents, dpkg-deb --info.
set -eu
. "$(dirname -- "$0")/common.sh"

command -v dpkg-shlibdeps > /dev/null ||
  die "a .deb needs dpkg-dev: apt-get install dpkg-dev; elsewhere cmake --install makes a tree to pack by other means"
"$root/tools/packages.sh" demo
host=$("$root/tools/host-plain.sh")
build=$root/build/package-${host##*/host-plain-}
make_folder "$build"
lock "$(build_lock "$build")"
say "configuring $build"
cmake -S "$root" -B "$build" -G Ninja -D LAMMPS_SOURCE_DIR="$(cat "$host/source")" -D LAMMPS_BUILD_DIR="$host" \
  -D CMAKE_INSTALL_PREFIX=/usr -D SPHTM_INSTALL_HOST=ON -D SPHTM_TESTS=OFF > "$build/configure.log" 2>&1 ||
  { cat "$build/configure.log" >&2; rm -f "$build/build.ninja"; die "CMake failed"; }
thin_ninja "$build/build.log" -C "$build" || die "the build failed"
say "packing"
rm -f "$build"/*.deb
(umask 022; cd "$build" && cpack -G DEB) > "$build/cpack.log" 2>&1 || { cat "$build/cpack.log" >&2; die "cpack failed"; }
results_in package
file=$(basename -- "$build"/*.deb)
mv "$build/$file" "$SPHTM_OUT/$file"
say "install it with: apt-get install $SPHTM_OUT/$file"
echo "$SPHTM_OUT/$file"
