#!/bin/sh
# Prints shell exports for work with a host and plugin by hand:  print-env.sh HOST PLUGIN
set -eu
. "$(dirname -- "$0")/common.sh"

use_host "$1" "$2"
for name in SPHTM_LMP LAMMPS_PLUGIN_PATH SPHTM_SOURCE SPHTM_BUILD SPHTM_MPIRUN OMP_NUM_THREADS; do
  eval "value=\$$name"
  printf "export %s='%s'\n" "$name" "$(printf '%s' "$value" | sed "s/'/'\\\\''/g")"
done
