#!/bin/sh
# A user's own build works: configured in a fresh folder with nothing but LAMMPS's two folders, built, loaded by lmp. What the build
# under test (SPHTM_BUILD) has compiled with the same command is not compiled again.
#   check-userbuild.sh LAMMPS_SRC LAMMPS_BUILD
set -eu
. "$(dirname -- "$0")/common.sh"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
cmake -S "$root" -B "$work/build" -D LAMMPS_SOURCE_DIR="$1" -D LAMMPS_BUILD_DIR="$2" \
  -D CMAKE_CXX_COMPILER_LAUNCHER="$root/tools/same-compile.py;$SPHTM_BUILD"
cmake --build "$work/build" --target sphtmplugin -j "$jobs"
printf 'plugin load "%s/build/sphtmplugin.so"\nplugin list\n' "$work" > "$work/in.load"
unset LAMMPS_PLUGIN_PATH
"$SPHTM_LMP" -in "$work/in.load" -log none > "$work/out" 2>&1 || { cat "$work/out"; die "lmp failed"; }
cat "$work/out"
grep -q 'pair style plugin sph/tm' "$work/out" || die "the plugin did not bring pair style sph/tm"
