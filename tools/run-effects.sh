#!/bin/sh
# What each effect costs on, off and in a build without the others: bench/effects.py.
set -eu
. "$(dirname -- "$0")/common.sh"

"$root/tools/packages.sh" effects
host=$("$root/tools/host-plain.sh")
plugin=$("$root/tools/build-plugin.sh" "$host")
use_host "$host" "$plugin"
SPHTM_OUT=$root/out/effects
SPHTM_MINIMAL_PLUGINS=
for effects in 'none' 'viscosity;plasticity;heat'; do
  build=$root/build/minimal-$(echo "$effects" | tr ';' '-')
  mkdir -p "$build"
  cmake -S "$root" -B "$build" -G Ninja -D LAMMPS_SOURCE_DIR="$(cat "$host/source")" -D LAMMPS_BUILD_DIR="$host" \
    -D SPHTM_TESTS=OFF -D SPHTM_MINIMAL_EFFECTS="$effects" > "$build/configure.log" 2>&1 ||
    { cat "$build/configure.log" >&2; die "CMake failed"; }
  thin_ninja "$build/build.log" -C "$build" || die "the build failed"
  SPHTM_MINIMAL_PLUGINS=$SPHTM_MINIMAL_PLUGINS:$effects=$build
done
export SPHTM_OUT SPHTM_MINIMAL_PLUGINS
mkdir -p "$SPHTM_OUT"
cd "$root"
exec /usr/bin/python3 bench/effects.py "$@"
