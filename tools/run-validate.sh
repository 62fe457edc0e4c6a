#!/bin/sh
# Against experiments: bench/validate/run.py. Results go to out/validate.
set -eu
. "$(dirname -- "$0")/common.sh"

prepare demo or-given
[ -n "${SPHTM_OUT:-}" ] || make_folder "$root/out/validate"
exec /usr/bin/python3 "$root/bench/validate/run.py" "$@"
