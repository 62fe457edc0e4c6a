# Sourced by the other scripts: where things are, and how to say what is going on.
# Progress goes to stderr, so that a script's answer can stand alone on stdout.
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
cache=${SPHTM_CACHE:-}    # empty: nobody says where
[ -n "$cache" ] || [ -z "${XDG_CACHE_HOME:-}" ] || cache=$XDG_CACHE_HOME/sphtm
[ -n "$cache" ] || [ -z "${HOME:-}" ] || cache=$HOME/.cache/sphtm
case $cache in /*|'') ;; *) cache=$PWD/$cache ;; esac
jobs=${SPHTM_JOBS:-$(getconf _NPROCESSORS_ONLN)}
lammps=${SPHTM_LAMMPS:-20250204}    # of which date is the LAMMPS that is fetched and built

say() { echo "sphtm: $*" >&2; }
die() { echo "sphtm: $*" >&2; exit 1; }
case $lammps in
  20250204|20260704) ;;
  *) die "no LAMMPS '$lammps' here: SPHTM_LAMMPS, or --lammps, is 20250204 or 20260704" ;;
esac

# What clean.sh may remove carries a mark: a folder the file $mark with the folder's name, so that no copy counts; a
# file such a file beside it, with its checksum; a lock its text.
mark=.sphtm-made
lock_text='lock of ./sphtm'

# make_folder FOLDER [NAME]: marks it, for NAME where it moves there later; one that holds something already is left
make_folder() {
  mkdir -p "$1" || die "cannot make the folder $1"
  [ -n "$(ls -A "$1")" ] || echo "${2:-${1##*/}}" > "$1/$mark" || die "cannot write into $1"
}
is_marked() { [ -d "$1" ] && [ ! -L "$1" ] && is_plain "$1/$mark" && [ "$(head -n 1 "$1/$mark")" = "${1##*/}" ]; }
mark_file() { (cd "${1%/*}" && sha256sum "${1##*/}" > ".${1##*/}$mark"); }
is_plain() { [ -f "$1" ] && [ ! -L "$1" ]; }

# Makes way for what is about to be made: make_way PATH...; what is not ours stops it
make_way() {
  for path; do
    if is_marked "$path"; then rm -rf "$path"
    elif [ -e "$path" ] || [ -L "$path" ]; then
      die "$path is in the way, not made by ./sphtm: move it, or set SPHTM_CACHE"
    fi
  done
}
# The same for what an interrupted call left: sweep PATH...
sweep() {
  for path; do ! is_marked "$path" || rm -rf "$path"; done
}

# The folder for what is built once; made here it says so, so that an empty one may go: need_cache
cache_text="the folder alone, not what is in it"
name_cache() {
  [ -n "$cache" ] ||
    die "HOME is not set, so there is no place for LAMMPS and its builds: set HOME, or SPHTM_CACHE to a folder for them"
}
need_cache() {
  name_cache
  [ ! -d "$cache" ] || return 0
  why=$(mkdir -p "$cache" 2>&1) || die "cannot make the cache folder: $why; set SPHTM_CACHE to one that can be written"
  echo "$cache_text" > "$cache/$mark" || die "cannot write into the cache folder $cache"
}

# need_space MEBIBYTES WHAT: in the cache
need_space() {
  free=$(df -Pk "$cache" 2> /dev/null | awk 'NR == 2 { print int($4 / 1024) }')
  [ -z "$free" ] || [ "$free" -ge "$1" ] ||
    die "$2 needs $1 MiB, and the disk of $cache has $free MiB left: make room, or set SPHTM_CACHE"
}

# What a log says of the machine, or nothing: cause_in LOG
cause_in() {
  if grep -qE 'No space left on device|Disk quota exceeded' "$1"; then echo ': the disk is full'
  elif grep -qE 'Read-only file system' "$1"; then echo ': the disk is read-only'
  elif grep -qE 'Killed signal|Killed \(program|virtual memory exhausted|out of memory' "$1"; then
    echo ': not enough memory; SPHTM_JOBS=1 takes less'
  elif grep -qE 'Could not (resolve|connect)|Temporary failure|Unable to connect|Cannot initiate' "$1" ||
    grep -qE 'Network is unreachable|Connection (timed out|refused|failed)' "$1"; then
    echo ': no network, or no way to the mirror (behind a proxy: set http_proxy)'
  fi
}

# One at a time: lock NAME waits until no other call holds NAME; the lock ends with the script.
lock() {
  need_cache
  [ ! -e "$cache/$1.lock" ] || is_plain "$cache/$1.lock" || die "$cache/$1.lock is not a file: move it away"
  true 2> /dev/null >> "$cache/$1.lock" ||
    die "cannot write into the cache folder $cache: set SPHTM_CACHE to a folder that can be written"
  exec 9>> "$cache/$1.lock"
  [ -s "$cache/$1.lock" ] || echo "$lock_text" >&9 || die "cannot write into the cache folder $cache: is the disk full?"
  flock -n 9 && return 0
  say "waiting for another sphtm that works on $1"
  flock -w 10800 9 || die "another sphtm has held $cache/$1.lock for three hours: end it, then try again"
}

# the name of the lock of a build folder
build_lock() { echo "plugin-$(echo "$1" | cksum | cut -d ' ' -f 1)"; }

# Lines "[done/all] ..." thinned. Not with awk: mawk reads a pipe in blocks, which may be more than a whole build writes
thinned() {
  t0=$(date +%s) shown=0
  while IFS= read -r line; do
    case $line in '['[0-9]*/[1-9]*']'*) ;; *) continue ;; esac
    line=${line#?}; line=${line%%]*}; n=${line%%/*} all=${line#*/}
    case $n$all in *[!0-9]*) continue ;; esac
    [ "$n" -gt 0 ] && p=$((100 * n / all)) && [ "$p" -ge $((shown + 5)) ] || continue
    shown=$p
    printf '  %3d%%  %d of %d, about %d s left\n' "$p" "$n" "$all" $((($(date +%s) - t0) * (all - n) / n))
  done
}

# Ninja with its hundreds of lines thinned to one for every five percent: thin_ninja LOG ARGS...
thin_ninja() {
  log=$1; shift
  { NINJA_STATUS='[%f/%t] ' nice -n 5 ninja -j "$jobs" "$@" 2>&1; echo "exit $?"; } | tee "$log" | thinned >&2
  case $(tail -n 1 "$log") in
    'exit 0') return 0 ;;
    *) grep -v '^\[' "$log" | head -n 80 >&2; cause=$(cause_in "$log"); [ -z "$cause" ] || say "the build stopped$cause"
       return 1 ;;
  esac
}

# How to start n ranks here: Open MPI refuses root and more ranks than cores unless told otherwise.
mpirun_command() {
  command -v mpirun > /dev/null || die "no mpirun on PATH: install an MPI (Debian: openmpi-bin), or add it to PATH"
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
  make_folder "$SPHTM_OUT"
  cd "$root"
}

# What demo.py, the tests and the bench find in their environment: use_host HOST PLUGIN
use_host() {
  SPHTM_MPIRUN=$(mpirun_command)
  SPHTM_LMP=$1/lmp LAMMPS_PLUGIN_PATH=$2 SPHTM_SOURCE=$root SPHTM_BUILD=$2
  OMP_NUM_THREADS=${OMP_NUM_THREADS:-1}
  export SPHTM_LMP LAMMPS_PLUGIN_PATH SPHTM_SOURCE SPHTM_BUILD SPHTM_MPIRUN OMP_NUM_THREADS
}
