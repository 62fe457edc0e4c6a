#!/bin/sh
# Hard cases: bench/stability/run.py with the plugin and its host.
set -eu
. "$(dirname -- "$0")/common.sh"

prepare demo
results_in stability
exec /usr/bin/python3 bench/stability/run.py "$@"
