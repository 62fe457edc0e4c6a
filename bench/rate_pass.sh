#!/bin/sh
# The rate pass alone (rate_pass.c), on one core: in double, in single, and with second order at free faces, in turns.
#
#     bench/rate_pass.sh [EDGE [ROUNDS]]      particles along an edge of the cube, 30; rounds, 6
#
# The loops are those of the best instruction set that this processor has.
set -eu
root=$(cd "$(dirname -- "$0")/.." && pwd)
edge=${1:-30} rounds=${2:-6}
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
case $(grep -m1 '^flags' /proc/cpuinfo) in
  *avx512vl*) isa="-mavx2 -mfma -mavx512f -mavx512dq -mavx512vl -mprefer-vector-width=512" ;;
  *avx2*) isa="-mavx2 -mfma" ;;
  *) isa= ;;
esac
include="-I$root/src/TM_CORE"
for d in "$root"/src/*/physics "$root"/src/*/particle; do include="$include -I$d"; done
usual="TM_FX_ONE_PASS | TM_FX_VISCOSITY | TM_FX_3D"
compile()
{
  name=$1 effects=$2
  shift 2
  # shellcheck disable=SC2086
  ${CC:-gcc} -std=gnu11 -O3 -fno-math-errno -fno-trapping-math -fopenmp-simd $isa $include "-DEFFECTS=($effects)" "$@" \
    "$root/bench/rate_pass.c" -o "$made/$name" -lm
}
compile double "$usual"
compile single "$usual" -DTM_PAIR_SINGLE
compile faces "$usual | TM_FX_FACES"
round=0
while [ $round -lt "$rounds" ]; do
  for name in double single faces; do
    printf '%-8s' $name
    "$made/$name" "$edge" $((540000 / (edge * edge * edge) + 4))
  done
  round=$((round + 1))
done
