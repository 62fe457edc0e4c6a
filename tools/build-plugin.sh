#!/bin/sh
# Prints the folder with sphtmplugin.so for a host; builds what has changed.
#   build-plugin.sh HOST [TARGET...]      HOST is a folder as host-plain.sh prints it; TARGET defaults to the plugin
set -eu
. "$(dirname -- "$0")/common.sh"

host=${1:?usage: build-plugin.sh HOST [TARGET...]}
shift
[ $# -gt 0 ] || set -- sphtmplugin
build=$root/build/${host##*/host-}
make_folder "$build"
lock "$(build_lock "$build")"
# also where the packages of the tests have come since: without them there is no harness
if [ ! -f "$build/build.ninja" ] ||
  { [ "$*" = all ] && grep -qsE '^(GTest_DIR|YAML_[A-Z_]*):.*NOTFOUND$' "$build/CMakeCache.txt"; }; then
  say "configuring $build"
  cmake -S "$root" -B "$build" -G Ninja -D LAMMPS_SOURCE_DIR="$(cat "$host/source")" -D LAMMPS_BUILD_DIR="$host" \
    > "$build/configure.log" 2>&1 || { cat "$build/configure.log" >&2; rm -f "$build/build.ninja"; die "CMake failed"; }
fi
thin_ninja "$build/build.log" -C "$build" "$@" || die "the build failed"
grep -h 'warning:' "$build/build.log" >&2 || true
echo "$build"
