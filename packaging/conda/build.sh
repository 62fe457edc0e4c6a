#!/bin/sh
# Called by conda-build. An installed LAMMPS has only some of its headers: they are taken from the source.
set -eu
# shellcheck disable=SC2086
cmake -S . -B build/conda -G Ninja $CMAKE_ARGS -D SPHTM_TESTS=OFF -D CMAKE_INSTALL_PREFIX="$PREFIX" -D CMAKE_INSTALL_LIBDIR=lib \
  -D LAMMPS_SOURCE_DIR="$SRC_DIR/lammps-source/src" -D LAMMPS_BUILD_DIR="$PREFIX"
cmake --build build/conda
cmake --install build/conda
