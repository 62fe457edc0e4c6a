#!/bin/sh
# What accuracy costs: sweeps of each knob, error against time; bench/accuracy/run.py. Results go to out/accuracy.
set -eu
. "$(dirname -- "$0")/common.sh"

prepare demo or-given
[ -n "${SPHTM_OUT:-}" ] || make_folder "$root/out/accuracy"
exec /usr/bin/python3 "$root/bench/accuracy/run.py" "$@"
