#!/bin/sh
# Prints the folder of a LAMMPS host (lmp, liblammps.so.0, CMakeCache.txt); builds it first if it is not in the cache.
#   host-plain.sh [plain|machdyn]     machdyn: the same with LAMMPS's SPH and total-Lagrangian SPH packages, for the bench
# SPHTM_LAMMPS says which LAMMPS. The folder's name ends in a hash of everything that shapes the build.
set -eu
. "$(dirname -- "$0")/common.sh"
. "$root/tools/host-build.sh"

variant=${1:-plain}
case $variant in
  plain)   packages='-DPKG_PLUGIN=ON' ;;
  machdyn) packages='-DPKG_PLUGIN=ON -DPKG_SPH=ON -DPKG_MACHDYN=ON -DDOWNLOAD_EIGEN3=OFF' ;;
  *) die "no host variant '$variant': plain or machdyn" ;;
esac
source=$("$root/tools/lammps-source.sh")
[ ! -d "$source/src/GRAPHICS" ] || packages="$packages -DPKG_GRAPHICS=ON"    # of newer versions: it has dump image
options="$host_options $packages"
build_host "$variant" "$(host_key "$source" "$options")" 5 "$source" "$options"
echo "$host"
