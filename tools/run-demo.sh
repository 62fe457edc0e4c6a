#!/bin/sh
# The demonstration: installs, builds and runs what it needs; results go to out/demo.
set -eu
. "$(dirname -- "$0")/common.sh"

"$root/tools/packages.sh" demo
host=$("$root/tools/host-plain.sh")
plugin=$("$root/tools/build-plugin.sh" "$host")
use_host "$host" "$plugin"
SPHTM_OUT=$root/out/demo
export SPHTM_OUT
mkdir -p "$SPHTM_OUT"
cd "$root"
exec /usr/bin/python3 examples/high_speed_machining/demo.py "$@"
