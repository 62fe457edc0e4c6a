#!/bin/sh
# What is there, and the command that mends what is missing:  doctor.sh [installed]
# Nothing is built or installed. It exits with 0 when a run can start.
set -eu
. "$(dirname -- "$0")/common.sh"
. "$root/tools/fit.sh"

mode=${1:-source}
case $mode in
  source) sphtm=./sphtm ;;
  installed) sphtm=sphtm ;;
  *) die "doctor.sh [installed]" ;;
esac

# row STATE WHAT TEXT [COMMAND]: ok, or missing and the like with the command that mends it
row() {
  printf '%-8s %-10s %s\n' "$1" "$2" "$3"
  [ -z "${4:-}" ] || printf '%-8s %-10s   %s\n' '' '' "$4"
}
# what to type to get Debian packages, if this is a Debian: install PACKAGE...
install_command() {
  if ! command -v apt-get > /dev/null; then echo "install what your system has for: $*"
  elif [ "$(id -u)" = 0 ]; then echo "apt-get install $*"
  else echo "sudo apt-get install $*"
  fi
}
own_build='cmake -S . -B build/own -D LAMMPS_SOURCE_DIR=<source> -D LAMMPS_BUILD_DIR=<build> && cmake --build build/own'

# Folders with a plugin, each with the lmp that goes with it where one does: PLUGIN|LMP
pairs() {
  [ -z "${LAMMPS_PLUGIN_PATH:-}" ] || echo "${LAMMPS_PLUGIN_PATH%%:*}|"
  if [ "$mode" = installed ]; then echo "$SPHTM_PLUGIN_DIR|$SPHTM_HOST_DIR/lmp"; return; fi
  for host in "$cache"/host-*; do
    build=$root/build/${host##*/host-}
    [ ! -f "$build/sphtmplugin.so" ] || echo "$build|$host/lmp"
  done
  for plugin in "$root"/build/*/sphtmplugin.so; do
    [ ! -f "$plugin" ] || [ -f "$cache/host-$(basename -- "$(dirname -- "$plugin")")/lmp" ] || echo "$(dirname -- "$plugin")|"
  done
}
# every LAMMPS there is, the one that a run takes first
programs() {
  [ -z "${SPHTM_LMP:-}" ] || command -v "$SPHTM_LMP" || echo "$SPHTM_LMP"
  pairs | sed -n 's/^[^|]*|\(..*\)/\1/p'
  for name in lmp lmp_mpi lmp_serial; do command -v $name || true; done
  for lmp in "$cache"/host-*/lmp; do [ ! -f "$lmp" ] || echo "$lmp"; done
}

plugins=$(pairs | cut -d '|' -f 1 | awk '!seen[$0]++')
hosts=$(programs | awk '!seen[$0]++')
runs='' misfits=0

look_at_plugins() {
  n=0
  while IFS= read -r plugin; do
    [ -n "$plugin" ] || continue
    text=$(built_for "$plugin")
    if [ -n "$text" ]; then row ok plugin "$plugin: for LAMMPS $text"; n=$((n + 1))
    else row broken plugin "$plugin: no sphtmplugin.so with sphtm_styles.so there"
    fi
  done <<END
$plugins
END
  [ $n -gt 0 ] && return
  if [ "$mode" = source ]; then row missing plugin "not built yet" './sphtm build'
  else row missing plugin "not in $SPHTM_PLUGIN_DIR" 'install SPH-TM again: cmake --install <build>, or its package'
  fi
}

# each LAMMPS with the first plugin that it fits; runs is what can be started
look_at_hosts() {
  n=0
  while IFS= read -r lmp; do
    [ -n "$lmp" ] || continue
    if [ ! -e "$lmp" ]; then
      [ "$lmp" != "${SPHTM_LMP:-}" ] || row broken LAMMPS "SPHTM_LMP=$lmp: not there" 'unset SPHTM_LMP'
      continue
    fi
    n=$((n + 1))
    about=$(about_lmp "$lmp") why='there is no plugin'
    while IFS= read -r plugin; do
      [ -n "$plugin" ] && [ -n "$(built_for "$plugin")" ] || continue
      why=$(misfit "$(built_for "$plugin")" "$about")
      [ -n "$why" ] || loads "$lmp" "$plugin" || why="does not load the plugin: $(echo "$load_said" | grep -iE 'fail|error|undefined' | head -n 1)"
      [ -n "$why" ] || break
    done <<END
$plugins
END
    if [ -z "$why" ]; then
      row ok LAMMPS "$lmp: $about; it loads $plugin"
      [ -n "$runs" ] || runs="$lmp|$plugin"
    elif [ "$why" = 'there is no plugin' ]; then row ok LAMMPS "$lmp: $about"
    else
      case $why in
        'cannot start: MPI'*) row broken LAMMPS "$lmp $why" ;;    # the row of MPI says the rest
        'cannot start'*) row broken LAMMPS "$lmp $why" "ldd $lmp    # names all that it lacks" ;;
        *) row unfit LAMMPS "$lmp $why"; misfits=$((misfits + 1)) ;;
      esac
    fi
  done <<END
$hosts
END
  if [ "$n" -eq 0 ]; then
    if [ "$mode" = source ]; then row missing LAMMPS 'none in SPHTM_LMP, on PATH or in the cache' './sphtm build'
    else row missing LAMMPS 'none in SPHTM_LMP, beside the plugin, on PATH or in the cache' 'SPHTM_LMP=<lmp> sphtm doctor'
    fi
  elif [ -z "$runs" ] && [ $misfits -gt 0 ]; then
    if [ "$mode" = source ]; then row none LAMMPS 'no LAMMPS here fits a plugin here' './sphtm build'
    else row none LAMMPS "no LAMMPS here fits the plugin; to build it for one of yours, in SPH-TM's source folder:" "$own_build"
    fi
  fi
}

look_at_mpi() {
  if ! command -v mpirun > /dev/null; then
    row missing MPI 'no mpirun: runs on one core only, no demo and no studies' "$(install_command openmpi-bin)"
    return
  fi
  said=$(mpirun --version 2> /dev/null | head -n 1)
  want=$([ -z "$runs" ] || built_for "${runs#*|}")
  case $(mpi_family "$want")/$(mpi_family "$said") in
    */unknown|unknown/*|'Open MPI/Open MPI'|MPICH/MPICH) row ok MPI "$(command -v mpirun): $said" ;;
    *) row unfit MPI "$(command -v mpirun) is $said, LAMMPS and plugin are built with $(mpi_family "$want")" \
      "PATH=<folder of that MPI's mpirun>:\$PATH $sphtm doctor" ;;
  esac
}

look_at_gpu() {
  if command -v nvidia-smi > /dev/null && said=$(nvidia-smi --query-gpu=name,driver_version --format=csv,noheader 2> /dev/null) &&
    [ -n "$said" ]; then
    echo "$said" | while IFS= read -r line; do row ok GPU "$line (name, driver)"; done
  elif grep -qs 0x10de /sys/bus/pci/devices/*/vendor; then
    row missing GPU 'an NVIDIA GPU without a driver that answers' "$(install_command nvidia-driver) (Debian: from non-free)"
  else row none GPU 'no NVIDIA GPU: runs go on the CPU'
  fi
  kokkos=$(echo "$hosts" | while IFS= read -r lmp; do
    [ ! -x "$lmp" ] || case $(about_lmp "$lmp") in *', with Kokkos') echo "$lmp" ;; esac; done)
  if [ -n "$kokkos" ]; then row ok Kokkos "$(echo "$kokkos" | tr '\n' ' ')"
  elif [ "$mode" = source ]; then
    row none Kokkos 'no LAMMPS with Kokkos: no GPU, no threads' 'Kokkos_ROOT=<folder> ./sphtm host-cuda    (on CPUs: host-kokkos)'
  else row none Kokkos "no LAMMPS with Kokkos: no GPU, no threads; in SPH-TM's source folder:" 'Kokkos_ROOT=<folder> ./sphtm host-cuda'
  fi
}

look_at_python() {
  python=python3
  [ "$mode" = installed ] && command -v python3 > /dev/null || python=/usr/bin/python3
  if ! command -v $python > /dev/null; then
    row missing Python "no $python: no demo and no studies" "$(install_command python3 python3-numpy python3-matplotlib)"
    return
  fi
  for module in 'numpy demo and studies' 'matplotlib their pictures' 'scipy identify'; do
    name=${module%% *}
    if version=$($python -c "import $name; print($name.__version__)" 2> /dev/null); then row ok Python "$name $version"
    else row missing Python "$name, for ${module#* }" "$(install_command "python3-$name")"
    fi
  done
}

look_at_packages() {
  [ "$mode" = source ] && command -v dpkg-query > /dev/null || return 0
  for set in demo manual test; do
    missing=$("$root/tools/packages.sh" $set list)
    [ -n "$missing" ] || { row ok packages "all that ./sphtm $set needs"; continue; }
    row missing packages "for ./sphtm $set, which installs them itself:$missing" "$(install_command $missing)"
  done
}

if [ "$mode" = installed ]; then echo "SPH-TM ${SPHTM_VERSION:-}, commit ${SPHTM_COMMIT:-unknown}, installed in $root"
else echo "SPH-TM in $root"
fi
look_at_plugins
look_at_hosts
look_at_mpi
look_at_gpu
look_at_python
look_at_packages
if [ -n "$runs" ]; then
  case ${runs%|*} in
    "$cache"/host-*|"${SPHTM_HOST_DIR:-none}"/lmp) echo "A run can start: $sphtm lmp -in in.script" ;;
    *) echo "A run can start: LAMMPS_PLUGIN_PATH=${runs#*|} ${runs%|*} -in in.script" ;;
  esac
  exit 0
fi
echo "No run can start yet; what is missing or unfit above says how to mend it"
exit 1
