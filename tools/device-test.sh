#!/bin/sh
# The test of the physics headers on a GPU (unittest/device):
#   device-test.sh PROGRAM [ARCH]    compiles it, for sm_90 or ARCH
#   device-test.sh                   compiles it and every C test with nvcc, and runs it where there is a GPU
# With no nvcc it exits with 77.
set -eu
. "$(dirname -- "$0")/common.sh"

PATH=$PATH:/usr/local/cuda/bin
command -v nvcc > /dev/null || { echo "SKIPPED: physics on the GPU, no nvcc here"; exit 77; }
cd "$root"
folders=$(find src unittest/c -type d -printf ' -I%p')
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

program=${1:-$work/device}
for file in $(find src -name '*.c') unittest/device/on_host.c; do
  ${CC:-cc} -std=c11 -O2 -fno-math-errno -fno-trapping-math -fopenmp-simd $folders -c "$file" -o "$work/$(basename "$file").o"
done
nvcc -std=c++17 -O3 "-arch=${2:-sm_90}" -cudart static -diag-suppress 177 $folders unittest/device/device.cu "$work"/*.o -o "$program"
[ $# -eq 0 ] || exit 0

ls unittest/c/test_*.c | xargs -P "$jobs" -I{} sh -c "nvcc -x cu -std=c++17 -arch=sm_90 -diag-suppress 177 \
  -DSPHTM_SOURCE='\"$root\"' $folders -c {} -o \"$work/\$(basename {}).o\" || { echo 'fails: {}'; exit 1; }"
echo "$(ls unittest/c/test_*.c | wc -l) C tests compile with nvcc"
status=0
"$program" || status=$?
[ $status -eq 77 ] || exit $status
