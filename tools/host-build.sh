# Sourced after common.sh by the scripts that build LAMMPS hosts.

# What all hosts have in common; each adds its own, and what comes last counts.
host_options="-DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O2 -DCMAKE_TUNE_FLAGS= -DBUILD_SHARED_LIBS=ON
  -DCMAKE_BUILD_RPATH_USE_ORIGIN=ON -DLAMMPS_SIZES=smallbig -DBUILD_MPI=ON -DBUILD_OMP=OFF -DFFT=KISS
  -DWITH_PNG=ON -DWITH_JPEG=ON -DWITH_GZIP=ON -DWITH_FFMPEG=OFF -DWITH_CURL=OFF -DDOWNLOAD_POTENTIALS=OFF"

version_of() { "$@" --version 2> /dev/null | head -n 1; }

# host_key SOURCE OPTIONS: a hash of everything that shapes the build
host_key() {
  { cksum < "$1/src/version.h"; echo "$1"; echo "$2"; version_of "${CXX:-c++}"; version_of cmake
    version_of mpirun; uname -m; } | sha256sum | cut -c 1-12
}

# build_host NAME KEY MINUTES SOURCE OPTIONS: sets host, the folder in the cache; builds it first if it is not there.
# A build counts only when it is complete. The caller may have set:
#   prepare_tree     command with SOURCE and a folder: fills the folder with the source to build, if not SOURCE itself
#   check_host       command that shows in folder $work/host that the new lmp runs
build_host() {
  need_cache
  host=$cache/host-$1-$2
  [ -x "$host/lmp" ] && return
  lock "host-$1"
  [ -x "$host/lmp" ] && return

  make_way "$host"
  sweep "$cache/build-$1".*
  need_space 1500 "building LAMMPS"
  work=$(mktemp -d "$cache/build-$1.XXXXXX")
  make_folder "$work"
  trap 'rm -rf "$work"' EXIT
  trap 'exit 130' INT TERM
  say "building the $1 LAMMPS host once (about $3 minutes on two cores); later calls reuse it"
  tree=$4
  if [ -n "${prepare_tree:-}" ]; then tree=$work/source; $prepare_tree "$4" "$tree"; fi
  # no path of this machine in LAMMPS's messages; nvcc would not take the option. It is not in the key: it changes texts alone
  [ "$1" = cuda ] || CXXFLAGS="${CXXFLAGS:+$CXXFLAGS }-ffile-prefix-map=$tree/=lammps/"
  export CXXFLAGS="${CXXFLAGS:-}"
  # shellcheck disable=SC2086
  cmake -S "$tree/cmake" -B "$work" -G Ninja $5 > "$work/configure.log" 2>&1 ||
    { tail -n 40 "$work/configure.log" >&2; die "CMake could not configure LAMMPS$(cause_in "$work/configure.log")"; }
  thin_ninja "$work/build.log" -C "$work" || die "LAMMPS did not build"

  make_folder "$work/host" "${host##*/}"
  cp -P "$work"/lmp "$work"/liblammps.so* "$work/CMakeCache.txt" "$work/host/"
  echo "$4" > "$work/host/source"
  if [ -d "$work/kokkos_build-prefix/include" ]; then    # the Kokkos that LAMMPS downloaded: the plugin needs its headers
    mkdir "$work/host/kokkos"
    cp -R "$work/kokkos_build-prefix/include" "$work/kokkos_build-prefix/lib" "$work/host/kokkos/"
  fi
  strip --strip-unneeded "$work/host/lmp" "$work"/host/liblammps.so.?
  ( cd "$work/host" && ${check_host:-./lmp -h} > help.txt 2>&1 ) ||
    { cat "$work/host/help.txt" >&2; die "the new lmp does not run"; }
  mv "$work/host" "$host"
}
