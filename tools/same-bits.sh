#!/bin/sh
# Are the results of two builds the same bits?
#   same-bits.sh record FOLDER      what all scene tests and the harness compute with this build, into FOLDER
#   same-bits.sh compare OLD NEW    two such folders
# A record has the thermo tables of every run with all their digits, wall times left out, the particles at its end and
# the values of LAMMPS's test harness. SPHTM_PLUGIN=FOLDER records with the plugin there: so the tests of one
# commit run with the plugin of another. SPHTM_SCENES='test_a test_b' records only these, and no harness.
set -eu
. "$(dirname -- "$0")/common.sh"

record() {
  mkdir -p "$1"
  SPHTM_RECORD=$(CDPATH='' cd -- "$1" && pwd)
  export SPHTM_RECORD
  host=$("$root/tools/host-plain.sh")
  build=$("$root/tools/build-plugin.sh" "$host")
  [ -n "${SPHTM_SCENES:-}" ] || build=$("$root/tools/build-plugin.sh" "$host" all)
  use_host "$host" "${SPHTM_PLUGIN:-$build}"
  export OMP_NUM_THREADS=1 PYTHONDONTWRITEBYTECODE=1 SPHTM_SOURCE="$root" SPHTM_BUILD="$build"
  # what damages files on purpose, or runs for its wall time, says nothing of bits
  scenes=${SPHTM_SCENES:-$(cd "$root/unittest/scenes" && ls test_*.py | sed 's/\.py$//' |
    grep -vE '^test_(restart_damage|contact_cost|docs|library)$')}
  for scene in $scenes; do echo "$scene"; done |
    xargs -P "$jobs" -I{} sh -c '/usr/bin/python3 "$0/unittest/scenes/{}.py" > "$1/{}.said" 2>&1 || echo "fails: {}" >&2' \
      "$root" "$SPHTM_RECORD"
  for file in "$root"/unittest/harness/yaml/*.yaml; do
    [ -z "${SPHTM_SCENES:-}" ] || break
    name=$(basename -- "$file" .yaml)
    case $name in pair-*) program=test_pair_style ;; *) program=test_fix_timestep ;; esac
    (cd "$root/unittest/harness/yaml" && "$build/unittest/harness/$program" "$file" -g "$SPHTM_RECORD/$name.yaml") \
      > /dev/null 2>&1 || echo "fails: $name" >&2
    [ ! -f "$SPHTM_RECORD/$name.yaml" ] || grep -vE '^(date_generated|lammps_version):' "$SPHTM_RECORD/$name.yaml" \
      > "$SPHTM_RECORD/$name" && rm -f "$SPHTM_RECORD/$name.yaml"
  done
  rm -f "$SPHTM_RECORD"/*.said
  say "$(ls "$SPHTM_RECORD" | wc -l) records in $1"
}

compare() {
  differ=0 same=0
  for file in "$2"/*; do
    if cmp -s "$file" "$1/${file##*/}"; then same=$((same + 1))
    else differ=$((differ + 1)); echo "differs: ${file##*/}"
    fi
  done
  [ $same -gt 0 ] || die "no records in $2 that are in $1 too"
  echo "$same records are the same, $differ differ, $(ls "$1" | wc -l) in $1"
  [ $differ = 0 ]
}

case ${1:-} in
  record) record "${2:?same-bits.sh record FOLDER}" ;;
  compare) compare "${2:?same-bits.sh compare OLD NEW}" "${3:?same-bits.sh compare OLD NEW}" ;;
  *) die "same-bits.sh record FOLDER | compare OLD NEW" ;;
esac
