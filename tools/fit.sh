# Sourced after common.sh: which LAMMPS a plugin was built for, what an lmp is, and whether the two fit.
# A description is one line: VERSION, SIZES, MPI, with|without Kokkos

# built_for FOLDER: the description of the LAMMPS that the plugin in FOLDER is for; nothing where there is no plugin
built_for() {
  [ -f "$1/sphtmplugin.so" ] && [ -f "$1/sphtm_styles.so" ] || return 0
  grep -a -o 'built for LAMMPS [ -~]*' "$1/sphtmplugin.so" | sed -n '1s/^built for LAMMPS //p'
}

# about_lmp PROGRAM: its description, or a line that begins with "cannot" or "has no"
about_lmp() {
  [ -x "$1" ] && [ ! -d "$1" ] || { echo "cannot be run"; return; }
  # a program that waits for something is none of ours
  timeout 20 "$1" -h < /dev/null 2>&1 | awk '
    /^Large-scale Atomic.* - / { version = $0; sub(/^[^-]*-[^-]* - /, "", version); sub(/ - .*/, "", version) }
    /^-DLAMMPS_(SMALLBIG|BIGBIG|SMALLSMALL)/ { sizes = tolower(substr($1, 10)) }
    /^MPI v/ { mpi = $0; sub(/^[^:]*: */, "", mpi); sub(/,.*/, "", mpi); gsub(/[[:space:]]+/, " ", mpi) }
    /^KOKKOS package API/ { kokkos = 1 }
    /(^|[[:space:]])plugin([[:space:]]|$)/ { plugin = 1 }
    /error while loading shared libraries/ { sub(/.*: error while/, "error while"); broken = $0 }
    /MPI_Init|orte_init/ && !version { broken = "MPI does not (Open MPI wants its programs too: openmpi-bin)" }
    END {
      if (mpi ~ /STUBS/) mpi = "no MPI"
      if (broken) print "cannot start: " broken
      else if (!version) print "cannot be asked with -h: no LAMMPS?"
      else if (!plugin) print "has no plugin command (LAMMPS " version ", built without PKG_PLUGIN)"
      else print version ", " (sizes ? sizes : "sizes unknown") ", " (mpi ? mpi : "an unknown MPI") ", " \
        (kokkos ? "with" : "without") " Kokkos"
    }'
}

# the family of an MPI: libraries of one take each other's programs
mpi_family() {
  case $1 in
    *'no MPI'*) echo none ;;
    *'Open MPI'*) echo 'Open MPI' ;;
    *MPICH*|*HYDRA*|*Intel*|*MVAPICH*) echo MPICH ;;
    *) echo unknown ;;
  esac
}

# misfit BUILT_FOR LMP: what does not fit, of two descriptions; nothing where all does
misfit() {
  case $2 in 'cannot '*|'has no '*) echo "$2"; return ;; esac
  [ "${1%%,*}" = "${2%%,*}" ] || { echo "is LAMMPS ${2%%,*}, the plugin is for ${1%%,*}"; return; }
  built=${1#*, } there=${2#*, }
  [ "${built%%,*}" = "${there%%,*}" ] || { echo "has ${there%%,*} integers, the plugin is for ${built%%,*}"; return; }
  built=$(mpi_family "$1") there=$(mpi_family "$2")
  case $built/$there in
    unknown/*|*/unknown|"$built/$built") ;;
    *) echo "is built with $(echo "$2" | cut -d , -f 3 | sed 's/^ //'), the plugin with $(echo "$1" | cut -d , -f 3 |
      sed 's/^ //')"; return ;;
  esac
  case $1/$2 in *'with Kokkos/'*'without Kokkos') echo "has no Kokkos, the plugin is for one with it" ;; esac
}

# loads LMP FOLDER: does this lmp bring the styles of the plugin in FOLDER? What it says is in $load_said
loads() {
  load_said=$(printf 'plugin list\n' | LAMMPS_PLUGIN_PATH=$2 timeout 60 "$1" -log none 2>&1) || true
  case $load_said in *'pair style plugin sph/tm'*) return 0 ;; *) return 1 ;; esac
}
