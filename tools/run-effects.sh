#!/bin/sh
# What each effect costs on, off and in a build without the others: bench/effects.py.
set -eu
. "$(dirname -- "$0")/common.sh"

prepare effects
SPHTM_MINIMAL_PLUGINS=
for effects in 'none' 'viscosity;plasticity;heat' 'viscosity;correction;hourglass'; do
  build=$root/build/minimal-$(echo "$effects" | tr ';' '-')
  make_folder "$build"
  cmake -S "$root" -B "$build" -G Ninja -D LAMMPS_SOURCE_DIR="$(cat "$host/source")" -D LAMMPS_BUILD_DIR="$host" \
    -D SPHTM_TESTS=OFF -D SPHTM_MINIMAL_EFFECTS="$effects" > "$build/configure.log" 2>&1 ||
    { cat "$build/configure.log" >&2; die "CMake failed"; }
  thin_ninja "$build/build.log" -C "$build" || die "the build failed"
  SPHTM_MINIMAL_PLUGINS=$SPHTM_MINIMAL_PLUGINS:$effects=$build
done
export SPHTM_MINIMAL_PLUGINS
results_in effects
exec /usr/bin/python3 bench/effects.py "$@"
