# Sourced by the other scripts: where things are, and how to say what is going on.
# Progress goes to stderr, so that a script's answer can stand alone on stdout.
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
cache=${SPHTM_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/sphtm}
case $cache in /*) ;; *) cache=$PWD/$cache ;; esac
jobs=${SPHTM_JOBS:-$(getconf _NPROCESSORS_ONLN)}

say() { echo "sphtm: $*" >&2; }
die() { echo "sphtm: $*" >&2; exit 1; }

# One at a time: lock NAME waits until no other call holds NAME; the lock ends with the script.
lock() {
  mkdir -p "$cache"
  exec 9> "$cache/$1.lock"
  flock -n 9 || { say "waiting for another sphtm that works on $1"; flock 9; }
}

# Ninja with its hundreds of lines thinned to one for every five percent: thin_ninja LOG ARGS...
thin_ninja() {
  log=$1; shift
  { NINJA_STATUS='[%f/%t] ' nice -n 5 ninja -j "$jobs" "$@" 2>&1; echo "exit $?"; } | tee "$log" |
    awk 'function left() { return (n ? int((systime() - t0) * (a[2] - n) / n) : 0) }
         BEGIN { t0 = systime(); shown = 0 }
         /^\[[0-9]+\/[0-9]+\]/ { split(substr($1, 2), a, /[\/\]]/); n = a[1]; p = int(100 * n / a[2])
           if (n > 0 && p >= shown + 5) { shown = p; printf "  %3d%%  %d of %d, about %d s left\n", p, n, a[2], left()
             fflush() } }' >&2
  case $(tail -n 1 "$log") in
    'exit 0') return 0 ;;
    *) grep -v '^\[' "$log" | head -n 80 >&2; return 1 ;;
  esac
}

# How to start n ranks here: Open MPI refuses root and more ranks than cores unless told otherwise.
mpirun_command() {
  case $(mpirun --version 2> /dev/null) in
    *'Open MPI'*) echo 'mpirun --allow-run-as-root --oversubscribe --bind-to none' ;;
    *) echo mpirun ;;
  esac
}

# LAMMPS, the plugin for it and the packages they need, built where they are not, in the environment. With "or-given" as
# the second word a host that is there already, one with Kokkos for example, is taken: prepare PACKAGES [or-given]
prepare() {
  "$root/tools/packages.sh" "$1"
  [ "${2:-}" != or-given ] || [ -z "${SPHTM_LMP:-}" ] || return 0
  host=$("$root/tools/host-plain.sh")
  plugin=$("$root/tools/build-plugin.sh" "$host")
  use_host "$host" "$plugin"
}

# Results go to out/NAME, and the script goes on in the top folder: results_in NAME
results_in() {
  SPHTM_OUT=$root/out/$1
  export SPHTM_OUT
  mkdir -p "$SPHTM_OUT"
  cd "$root"
}

# What demo.py, the tests and the bench find in their environment: use_host HOST PLUGIN
use_host() {
  SPHTM_LMP=$1/lmp LAMMPS_PLUGIN_PATH=$2 SPHTM_SOURCE=$root SPHTM_BUILD=$2 SPHTM_MPIRUN=$(mpirun_command)
  OMP_NUM_THREADS=${OMP_NUM_THREADS:-1}
  export SPHTM_LMP LAMMPS_PLUGIN_PATH SPHTM_SOURCE SPHTM_BUILD SPHTM_MPIRUN OMP_NUM_THREADS
}
