#!/bin/sh
# The benchmarks: bench/run.py with the plugin, its host and the host with LAMMPS's own SPH packages.
set -eu
. "$(dirname -- "$0")/common.sh"

[ -f "$root/bench/run.py" ] || die "there is no bench/run.py"
"$root/tools/packages.sh" bench
host=$("$root/tools/host-plain.sh")
peer=$("$root/tools/host-plain.sh" machdyn)
plugin=$("$root/tools/build-plugin.sh" "$host")
use_host "$host" "$plugin"
SPHTM_LMP_MACHDYN=$peer/lmp SPHTM_OUT=$root/out/bench
export SPHTM_LMP_MACHDYN SPHTM_OUT
mkdir -p "$SPHTM_OUT"
cd "$root"
exec /usr/bin/python3 bench/run.py "$@"
