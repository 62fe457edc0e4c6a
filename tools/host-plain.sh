#!/bin/sh
# Prints the folder of a LAMMPS host (lmp, liblammps.so.0, CMakeCache.txt); builds it first if it is not in the cache.
#   host-plain.sh [plain|machdyn]     machdyn: the same with LAMMPS's SPH and total-Lagrangian SPH packages, for the bench
# The folder's name ends in a hash of everything that shapes the build. A build counts only when it is complete.
set -eu
. "$(dirname -- "$0")/common.sh"

variant=${1:-plain}
case $variant in
  plain)   packages='-DPKG_PLUGIN=ON' ;;
  machdyn) packages='-DPKG_PLUGIN=ON -DPKG_SPH=ON -DPKG_MACHDYN=ON -DDOWNLOAD_EIGEN3=OFF' ;;
  *) die "no host variant '$variant': plain or machdyn" ;;
esac
options="-DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O2 -DCMAKE_TUNE_FLAGS= -DBUILD_SHARED_LIBS=ON
  -DCMAKE_BUILD_RPATH_USE_ORIGIN=ON -DLAMMPS_SIZES=smallbig -DBUILD_MPI=ON -DBUILD_OMP=OFF -DFFT=KISS
  -DWITH_PNG=ON -DWITH_JPEG=ON -DWITH_GZIP=ON -DWITH_FFMPEG=OFF -DWITH_CURL=OFF -DDOWNLOAD_POTENTIALS=OFF $packages"

version_of() { "$@" --version 2> /dev/null | head -n 1; }
source=$("$root/tools/lammps-source.sh")
key=$({ cksum < "$source/src/version.h"; echo "$source"; echo "$options"; version_of "${CXX:-c++}"; version_of cmake
        version_of mpirun; uname -m; } | sha256sum | cut -c 1-12)
host=$cache/host-$variant-$key
[ -x "$host/lmp" ] && { echo "$host"; exit 0; }
lock "host-$variant"
[ -x "$host/lmp" ] && { echo "$host"; exit 0; }

rm -rf "$cache/build-$variant".*    # what an interrupted build left
work=$(mktemp -d "$cache/build-$variant.XXXXXX")
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
say "building the $variant LAMMPS host once (about 5 minutes on two cores); later calls reuse it"
# shellcheck disable=SC2086
cmake -S "$source/cmake" -B "$work" -G Ninja $options > "$work/configure.log" 2>&1 ||
  { tail -n 40 "$work/configure.log" >&2; die "CMake could not configure LAMMPS"; }
thin_ninja "$work/build.log" -C "$work" || die "LAMMPS did not build"

mkdir "$work/host"
cp -P "$work"/lmp "$work"/liblammps.so* "$work/CMakeCache.txt" "$work/host/"
echo "$source" > "$work/host/source"
strip --strip-unneeded "$work/host/lmp" "$work"/host/liblammps.so.?
( cd "$work/host" && ./lmp -h > help.txt 2>&1 ) || { cat "$work/host/help.txt" >&2; die "the new lmp does not run"; }
mv "$work/host" "$host"
echo "$host"
