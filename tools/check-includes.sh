#!/bin/sh
# The C (tm_*.h and *.c of src) includes standard C headers and our own C headers, nothing of LAMMPS or Kokkos.
#   check-includes.sh LAMMPS_SRC
set -eu
. "$(dirname -- "$0")/common.sh"

cd "$root"
standard='assert|ctype|errno|float|inttypes|limits|locale|math|stdarg|stdbool|stddef|stdint|stdio|stdlib|string|time'
files=$(find src -name 'tm_*.h' -o -name '*.c' | sort)
bad=$(grep -nE '^[[:space:]]*#[[:space:]]*include' $files /dev/null | grep -vE "<($standard)\.h>" |
  while IFS= read -r line; do
    name=$(echo "$line" | sed -n 's/.*include[[:space:]]*"\([^"]*\)".*/\1/p')
    ours=$(find src -name "${name:-none}")
    # ours in C: named tm_*.h, or the header of one of our .c files
    case $name in tm_*.h) [ -n "$ours" ] && continue ;; esac
    [ -n "$ours" ] && [ -f "${ours%.h}.c" ] && [ ! -f "$1/$name" ] && continue
    echo "$line"
  done)
[ -z "$bad" ] || { echo "$bad"; die "the C may only include standard C and our own C headers"; }
echo "$(echo "$files" | wc -l) files include only C"
