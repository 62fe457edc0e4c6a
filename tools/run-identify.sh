#!/bin/sh
# Constants from measured forces: bench/validate/identify.py. Results go to out/identify.
set -eu
. "$(dirname -- "$0")/common.sh"

prepare identify or-given
[ -n "${SPHTM_OUT:-}" ] || make_folder "$root/out/identify"
exec /usr/bin/python3 "$root/bench/validate/identify.py" "$@"
