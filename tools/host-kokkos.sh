#!/bin/sh
# Prints the folder of a LAMMPS host with the KOKKOS package; builds it first if it is not in the cache.
#   host-kokkos.sh [openmp|cuda] [quiet]     openmp: OpenMP and Serial on the CPU; cuda: as the Kokkos found was installed
# Kokkos is the installed one that CMake finds (Kokkos_ROOT=<its prefix>); without one, the newest host in the cache; for
# openmp, else, the one LAMMPS downloads where there is internet. With none of these it says so, or
# with 'quiet' does not, and exits with 77.
# The folder's name ends in a hash of everything that shapes the build.
set -eu
. "$(dirname -- "$0")/common.sh"
. "$root/tools/host-build.sh"
. "$root/tools/kokkos.sh"

devices=${1:-openmp}
case $devices in
  openmp) name=kokkos minutes=8 what='Kokkos with OpenMP' ;;
  cuda)   name=cuda minutes=40 what='Kokkos with CUDA' ;;
  *) die "no host variant '$devices': openmp or cuda" ;;
esac
quiet=''
case ${2:-} in
  '') ;;
  quiet) quiet=yes ;;
  *) die "host-kokkos.sh [openmp|cuda] [quiet]" ;;
esac

# Of LAMMPS's Kokkos pair styles these are compiled; they take longer than all the rest, and no scene uses the others
kept_pairs='hybrid hybrid_overlay lj_cut'
# With nvcc every file counts: other styles that no scene uses
left_out=
[ $devices = openmp ] || left_out='fix_deform fix_dt_reset fix_efield fix_langevin fix_neigh_history fix_nph fix_npt fix_nve_limit
  fix_nve_sphere fix_nvt fix_nvt_sllod fix_recenter fix_spring_self fix_temp_berendsen fix_temp_rescale fix_wall_lj93
  fix_wall_region compute_coord_atom compute_erotate_sphere compute_orientorder_atom compute_temp_deform'

# prepare_tree SOURCE FOLDER: a copy without them
without_unused() {
  mkdir -p "$2"
  cp -R "$1/cmake" "$1/src" "$1/lib" "$1/LICENSE" "$2/"
  for header in "$2"/src/KOKKOS/pair_*_kokkos.h; do
    style=${header##*/pair_}
    case " $kept_pairs " in *" ${style%_kokkos.h} "*) ;; *) rm -f "$header" "${header%.h}.cpp" ;; esac
  done
  for style in $left_out; do rm -f "$2/src/KOKKOS/${style}"_kokkos.*; done
}

# A build machine without GPU has no libcuda.so.1 either: the toolkit's stub lets lmp start
try_lmp() {
  stub=$work/stub
  if [ $devices = cuda ] && ! ldconfig -p 2> /dev/null | grep -q 'libcuda\.so\.1'; then
    mkdir -p "$stub"
    for folder in "${CUDA_HOME:-/usr/local/cuda}" "$(dirname -- "$(dirname -- "$(command -v nvcc)")")"; do
      [ ! -f "$folder/lib64/stubs/libcuda.so" ] || ln -sf "$folder/lib64/stubs/libcuda.so" "$stub/libcuda.so.1"
    done
  fi
  LD_LIBRARY_PATH=$stub${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH} ./lmp -h
}

source=$("$root/tools/lammps-source.sh")
options="$host_options -DPKG_PLUGIN=ON -DPKG_KOKKOS=ON -DCMAKE_CXX_STANDARD=$kokkos_cxx"
prepare_tree=without_unused check_host=try_lmp

if find_kokkos $devices; then
  options="$options -DEXTERNAL_KOKKOS=ON -DKokkos_DIR=$kokkos_dir"
  case $kokkos_devices in *OPENMP*) options="$options -DBUILD_OMP=ON" ;; esac
  if [ $devices = cuda ]; then
    export CMAKE_CXX_COMPILER_LAUNCHER="$root/tools/nvcc-where-needed.sh"
    # liblammps.so wants a driver that is not there while linking
    options="$options -DCMAKE_CXX_COMPILER=$kokkos_prefix/bin/nvcc_wrapper
      -DCMAKE_EXE_LINKER_FLAGS=-Wl,--allow-shlib-undefined"
  fi
  key=$(host_key "$source" "$options $kept_pairs $kokkos_version $kokkos_devices $kokkos_arch $kokkos_options${left_out:+ $left_out}")
  build_host $name "$key" $minutes "$source" "$options"
  echo "$host"; exit 0
fi

# the newest complete host of this LAMMPS whose Kokkos headers are still there: the plugin is compiled with them
for host in $(ls -td "$cache/host-$name-"*/ 2> /dev/null); do
  host=${host%/}
  dir=$(sed -n 's/^Kokkos_DIR:[A-Z]*=//p' "$host/CMakeCache.txt")
  [ -x "$host/lmp" ] && [ "$(cat "$host/source")" = "$source" ] || continue
  [ -f "$dir/KokkosConfig.cmake" ] || [ -d "$host/kokkos" ] || continue
  echo "$host"; exit 0
done

if [ $devices = openmp ] && kokkos_download; then
  options="$options -DDOWNLOAD_KOKKOS=ON -DKokkos_ENABLE_OPENMP=ON -DKokkos_ENABLE_SERIAL=ON -DBUILD_OMP=ON"
  build_host $name "$(host_key "$source" "$options $kept_pairs")" $minutes "$source" "$options"
  echo "$host"; exit 0
fi
[ -z "$quiet" ] || exit 77
[ -z "$kokkos_misfit" ] || kokkos_misfit=" (the one in $kokkos_prefix $kokkos_misfit)"
say "no $what found$kokkos_misfit: LAMMPS $lammps needs Kokkos $kokkos_words installed, and Kokkos_ROOT set to its folder"
exit 77
