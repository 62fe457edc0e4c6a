#!/bin/sh
# Every src/*/tm_*.h compiles alone, without a warning:  check-headers.sh c|c++|nvcc
set -eu
. "$(dirname -- "$0")/common.sh"

warnings='-fopenmp-simd -Wall -Wextra -Wpedantic -Wno-unused-function -Werror'
case ${1:-} in
  c)   compile="${CC:-cc} -std=c11 $warnings -Wc++-compat -x c -fsyntax-only" ;;
  c++) compile="${CXX:-c++} -std=c++17 $warnings -x c++ -fsyntax-only" ;;
  nvcc)
    PATH=$PATH:/usr/local/cuda/bin
    command -v nvcc > /dev/null || { echo "skipped: no nvcc here"; exit 77; }
    compile="nvcc -x cu -ptx -arch=sm_90 -diag-suppress 177 -Werror all-warnings -o /dev/null" ;;
  *) die "check-headers.sh c|c++|nvcc" ;;
esac

cd "$root"
folders=$(printf ' -I%s' src/*)
ls src/*/tm_*.h | xargs -P "$jobs" -I{} sh -c "$compile $folders {} || { echo 'fails: {}'; exit 1; }"
sh -c "$compile -DTM_PAIR_SINGLE $folders src/PAIR_SPH_TM/tm_rates.h"    # pair arithmetic in single
echo "$(ls src/*/tm_*.h | wc -l) headers compile alone with $compile"
