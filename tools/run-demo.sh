#!/bin/sh
# The demonstration: installs, builds and runs what it needs; results go to out/demo.
set -eu
. "$(dirname -- "$0")/common.sh"

prepare demo
results_in demo
exec /usr/bin/python3 examples/high_speed_machining/demo.py "$@"
