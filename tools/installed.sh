#!/bin/sh
# The installed command: sphtm help. <bin>/sphtm calls it and says where plugin (SPHTM_PLUGIN_DIR) and host (SPHTM_HOST_DIR) are.
set -eu
. "$(dirname -- "$0")/common.sh"
. "$root/tools/fit.sh"
SPHTM_COMMIT=$(cat "$root/commit" 2> /dev/null || echo unknown)
export SPHTM_COMMIT
for name in SPHTM_PLUGIN_DIR SPHTM_HOST_DIR; do
  eval "folder=\$$name"
  [ ! -d "$folder" ] || eval "$name=\$(CDPATH='' cd -- \"\$folder\" && pwd)"
done

usage() {
  cat <<END
usage: sphtm COMMAND        SPH-TM ${SPHTM_VERSION:-}, commit $SPHTM_COMMIT

  lmp [args]       run LAMMPS with the plugin loaded
  env              print shell exports:  eval "\$(sphtm env)"  sets SPHTM_LMP, LAMMPS_PLUGIN_PATH, SPHTM_MPIRUN
  doctor           what is installed, whether a run can start, and the command that mends what is missing
  demo             run the high-speed machining demonstration; --spacing 0.5: coarse, in seconds
  scenes [names]   run the full scenes of the examples
  validate [args]  measured cuts beside computed ones
  identify CASE    constants of material or friction from measured forces; --help
  many SCRIPT      one script with many sets of variables, several runs at once; --help
  accuracy [knobs] error against time for each knob; --quick
  stability [args] hard cases with a criterion each
  tool [args]      make the mesh of a tool: block, plane, ...; --help
  help             this text

Results go to out/COMMAND in the current folder, or to \$SPHTM_OUT. Examples, materials and pages:
$root
END
}

# sets lmp: $SPHTM_LMP, else the first that fits of the one installed along, lmp on PATH and those ./sphtm left in the cache
find_host() {
  want=$(built_for "$SPHTM_PLUGIN_DIR")
  [ -n "$want" ] || die "there is no plugin in $SPHTM_PLUGIN_DIR: install SPH-TM again"
  if [ -n "${SPHTM_LMP:-}" ]; then
    lmp=$(command -v "$SPHTM_LMP") || die "SPHTM_LMP=$SPHTM_LMP is no program"
    why=$(misfit "$want" "$(about_lmp "$lmp")")
    [ -z "$why" ] || die "SPHTM_LMP=$SPHTM_LMP $why (sphtm doctor says more)"
    return
  fi
  for lmp in "$SPHTM_HOST_DIR/lmp" "$(command -v lmp || true)" "$cache"/host-*/lmp; do
    [ -n "$lmp" ] && [ -x "$lmp" ] || continue
    [ -n "$(misfit "$want" "$(about_lmp "$lmp")")" ] || return 0
  done
  die "no LAMMPS $want found: set SPHTM_LMP to the lmp of one (sphtm doctor says more)"
}

# The environment of the studies, with results in NAME's folder: ready NAME
ready() {
  find_host
  find_python
  SPHTM_OUT=${SPHTM_OUT:-out/$1}
  case $SPHTM_OUT in /*) ;; *) SPHTM_OUT=$PWD/$SPHTM_OUT ;; esac    # runs have folders of their own
  SPHTM_LMP=$lmp SPHTM_SOURCE=$root LAMMPS_PLUGIN_PATH=$SPHTM_PLUGIN_DIR
  SPHTM_MPIRUN=$(mpirun_command) OMP_NUM_THREADS=${OMP_NUM_THREADS:-1} PYTHONDONTWRITEBYTECODE=1
  export SPHTM_LMP SPHTM_OUT SPHTM_SOURCE SPHTM_MPIRUN LAMMPS_PLUGIN_PATH OMP_NUM_THREADS PYTHONDONTWRITEBYTECODE
  mkdir -p "$SPHTM_OUT" || die "cannot make the folder $SPHTM_OUT: go where you may write, or set SPHTM_OUT"
}

# sets python: one with numpy, that of PATH or the system's
find_python() {
  for python in python3 /usr/bin/python3; do
    "$python" -c 'import numpy' 2> /dev/null && return
  done
  die "no python3 with numpy here (Debian: python3-numpy); sphtm doctor says what else is missing"
}

scenes() {
  names=
  while [ $# -gt 0 ]; do
    case $1 in -*) break ;; esac
    [ -f "$root/examples/$1/scene.py" ] ||
      die "no scene '$1'; there are$(cd "$root/examples" && printf ' %s' */scene.py | sed 's,/scene.py,,g')"
    names="$names $1"; shift
  done
  [ -n "$names" ] || names=$(cd "$root/examples" && printf ' %s' */scene.py | sed 's,/scene.py,,g')
  failed=
  for name in $names; do "$python" "$root/examples/$name/scene.py" "$@" || failed="$failed $name"; done
  [ -z "$failed" ] || die "failed:$failed"
}

command=${1:-help}
[ $# -gt 0 ] && shift
case $command in
  lmp) find_host; export LAMMPS_PLUGIN_PATH="$SPHTM_PLUGIN_DIR"; exec "$lmp" "$@" ;;
  env)
    find_host
    for pair in "SPHTM_LMP=$lmp" "LAMMPS_PLUGIN_PATH=$SPHTM_PLUGIN_DIR" "SPHTM_MPIRUN=$(mpirun_command)" \
      "OMP_NUM_THREADS=${OMP_NUM_THREADS:-1}"; do
      printf "export %s='%s'\n" "${pair%%=*}" "$(printf '%s' "${pair#*=}" | sed "s/'/'\\\\''/g")"
    done ;;
  doctor) exec "$root/tools/doctor.sh" installed ;;
  demo) ready demo; exec "$python" "$root/examples/high_speed_machining/demo.py" "$@" ;;
  scenes) ready scenes; scenes "$@" ;;
  validate|accuracy|stability) ready "$command"; exec "$python" "$root/bench/$command/run.py" "$@" ;;
  many) ready many; exec "$python" "$root/bench/many.py" "$@" ;;
  identify) ready identify; exec "$python" "$root/bench/validate/identify.py" "$@" ;;
  tool) if command -v python3 > /dev/null; then exec python3 "$root/tools/make_tool.py" "$@"; else die "no python3 here"; fi ;;
  test|sanitize|bench|effects|results|build|host|host-kokkos|host-cuda|gpu-bundle|package|manual|clean)
    die "'$command' builds or tests SPH-TM and needs its source tree: run ./sphtm $command there" ;;
  help|-h|--help) usage ;;
  *) echo "sphtm: no command '$command'" >&2; usage >&2; exit 2 ;;
esac
