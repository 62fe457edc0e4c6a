#!/bin/sh
# All tests, or those that match:  run-test.sh [LABEL | REGEX]
# Labels: unit, headers, driver, manual, harness, scene, kokkos, userbuild, install, package. The last line tells how many passed,
# failed and were skipped.
set -eu
. "$(dirname -- "$0")/common.sh"

"$root/tools/packages.sh" test
host=$("$root/tools/host-plain.sh")
build=$("$root/tools/build-plugin.sh" "$host" all)
say "testing in $build"

filter=${1:-}
cd "$build"
if [ -z "$filter" ]; then set --
elif ctest --print-labels | grep -qx "  $filter"; then set -- -L "^$filter\$"
else set -- -R "$filter"
fi

# Tests of the Kokkos styles need a second lmp and the plugin built for it
if ctest -N "$@" | grep -q ': kokkos_'; then
  status=0
  kokkos_host=$("$root/tools/host-kokkos.sh" openmp quiet) || status=$?
  case $status in
    0) kokkos_plugin=$("$root/tools/build-plugin.sh" "$kokkos_host")
       export SPHTM_LMP_KK="$kokkos_host/lmp" LAMMPS_PLUGIN_PATH_KK="$kokkos_plugin" ;;
    77) echo 'SKIPPED: Kokkos tests, no Kokkos for this LAMMPS found'
        [ "$filter" != kokkos ] || exit 0
        set -- "$@" -LE '^kokkos$' ;;
    *) exit $status ;;
  esac
fi

log=$build/test.log
{ ctest --output-on-failure -j "$jobs" "$@" 2>&1; echo "exit $?"; } | tee "$log" | grep --line-buffered -v '^exit '

awk -v filter="$filter" '
  /^ *[0-9]+\/[0-9]+ +Test +#[0-9]+:/ {
    if (/ Passed /) passed++
    else if (/\*\*\*Skipped/ || /\(Disabled\)/) skipped++
    else failed++
  }
  END {
    printf "%d passed, %d failed, %d skipped\n", passed, failed, skipped
    if (passed + failed + skipped == 0) { print "sphtm: no test matches " filter > "/dev/stderr"; exit 1 }
    exit $2 != 0 || failed > 0    # the last line is "exit <what ctest returned>"
  }' "$log"
