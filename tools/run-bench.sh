#!/bin/sh
# The benchmarks: bench/run.py with the plugin, its host and the host with LAMMPS's own SPH packages.
set -eu
. "$(dirname -- "$0")/common.sh"

prepare bench
peer=$("$root/tools/host-plain.sh" machdyn)
SPHTM_LMP_MACHDYN=$peer/lmp
export SPHTM_LMP_MACHDYN
results_in bench
exec /usr/bin/python3 bench/run.py "$@"
