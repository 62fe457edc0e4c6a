# Sourced after common.sh: which Kokkos there is. kokkos_wanted is the oldest that LAMMPS takes; each takes one major version,
# and is compiled with the C++ that this asks for.
if [ $lammps -lt 20260000 ]; then kokkos_wanted=4.5.01 kokkos_words='4.5.01 or later, but not 5,' kokkos_cxx=17
else kokkos_wanted=5.1.0 kokkos_words='5.1 or later' kokkos_cxx=20
fi

# find_kokkos openmp|cuda: sets kokkos_dir, _prefix, _version, _devices, _arch, _options; fails where there is none that fits,
# and with kokkos_misfit tells why
find_kokkos() {
  kokkos_dir='' kokkos_misfit=''
  probe=$(mktemp -d)
  cmake -S "$root/tools/kokkos-probe" -B "$probe" -DKOKKOS_WANTED=$kokkos_wanted > "$probe/log" 2>&1 || true
  if [ -f "$probe/answer.sh" ]; then . "$probe/answer.sh"
  else    # one whose own files for CMake stop it
    kokkos_prefix=$(sed -n 's/^CMake Error at \(.*\/Kokkos\)\/Kokkos[A-Za-z-]*\.cmake:.*/\1/p' "$probe/log" | head -n 1)
    missing=$(sed -n 's/^ *"\(\/.*\.\(a\|so[.0-9]*\)\)"$/\1/p' "$probe/log" | head -n 1)
    [ -z "$kokkos_prefix" ] || kokkos_misfit="is not whole: CMake fails in it${missing:+, $missing is missing}"
  fi
  rm -rf "$probe"
  [ -n "$kokkos_dir" ] || return 1
  case $1/$kokkos_devices in
    openmp/*CUDA*|openmp/*HIP*|openmp/*SYCL*) kokkos_misfit='is for a GPU' ;;
    openmp/*OPENMP*|cuda/*CUDA*) ;;
    openmp/*) kokkos_misfit='lacks OpenMP (Kokkos_ENABLE_OPENMP=ON)' ;;
    cuda/*) kokkos_misfit='lacks CUDA (Kokkos_ENABLE_CUDA=ON)' ;;
  esac
  case $kokkos_version/$kokkos_options in
    4.5.*|5.*|*IMPL_VIEW_LEGACY*) ;;
    *) kokkos_misfit="is version $kokkos_version with a View that this LAMMPS does not bear: configure it with Kokkos_ENABLE_IMPL_VIEW_LEGACY=ON" ;;
  esac
  [ -z "$kokkos_misfit" ]
}

# kokkos_download: can LAMMPS's own CMake download Kokkos here?
kokkos_download() {
  command -v curl > /dev/null || return 1
  curl -sfIL --max-time 15 "https://github.com/kokkos/kokkos/archive/$kokkos_wanted.tar.gz" > /dev/null 2>&1
}
