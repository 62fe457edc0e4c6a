#!/bin/sh
# The full scenes of examples/*/scene.py, or those named; results go to out/scenes/<name>. Options go to each scene.
#   run-scenes.sh [name ...] [--size small|default|large] [--repeats N] ...      bench/study.py says which
set -eu
. "$(dirname -- "$0")/common.sh"

names=
while [ $# -gt 0 ]; do
  case $1 in
    -*) break ;;
    *) [ -f "$root/examples/$1/scene.py" ] || die "no scene '$1'; there are$(cd "$root/examples" && printf ' %s' */scene.py | sed 's,/scene.py,,g')"
       names="$names $1"; shift ;;
  esac
done
[ -n "$names" ] || names=$(cd "$root/examples" && printf ' %s' */scene.py | sed 's,/scene.py,,g')

prepare demo or-given
[ -n "${SPHTM_OUT:-}" ] || make_folder "$root/out/scenes"
SPHTM_OUT=${SPHTM_OUT:-$root/out/scenes}
export SPHTM_OUT
failed=
for name in $names; do
  /usr/bin/python3 "$root/examples/$name/scene.py" "$@" || failed="$failed $name"
done
[ -z "$failed" ] || die "failed:$failed"
