#!/bin/sh
# One script with many sets of variables, several at a time: bench/many.py. Results go to out/many.
set -eu
. "$(dirname -- "$0")/common.sh"

prepare demo or-given
SPHTM_MATERIALS=${SPHTM_MATERIALS:-$root/materials}
export SPHTM_MATERIALS
exec /usr/bin/python3 "$root/bench/many.py" "$@"
