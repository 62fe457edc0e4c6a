#!/bin/sh
# Removes build/ and out/;  clean.sh all  also removes the LAMMPS source and hosts in the cache.
set -eu
. "$(dirname -- "$0")/common.sh"

rm -rf "$root/build" "$root/out"
case ${1:-} in
  '') ;;
  all) rm -rf "$cache" ;;
  *) die "clean.sh [all]" ;;
esac
