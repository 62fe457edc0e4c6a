#!/bin/sh
# Hard cases: bench/stability/run.py with the plugin and its host.
set -eu
. "$(dirname -- "$0")/common.sh"

"$root/tools/packages.sh" demo
host=$("$root/tools/host-plain.sh")
plugin=$("$root/tools/build-plugin.sh" "$host")
use_host "$host" "$plugin"
SPHTM_OUT=$root/out/stability
export SPHTM_OUT
mkdir -p "$SPHTM_OUT"
cd "$root"
exec /usr/bin/python3 bench/stability/run.py "$@"
