#!/bin/sh
# What accuracy costs: sweeps of each knob, error against time; bench/accuracy/run.py. Results go to out/accuracy.
set -eu
. "$(dirname -- "$0")/common.sh"

"$root/tools/packages.sh" demo
if [ -z "${SPHTM_LMP:-}" ]; then    # a host of one's own, one with Kokkos for example, can be in the environment
  host=$("$root/tools/host-plain.sh")
  plugin=$("$root/tools/build-plugin.sh" "$host")
  use_host "$host" "$plugin"
fi
exec /usr/bin/python3 "$root/bench/accuracy/run.py" "$@"
