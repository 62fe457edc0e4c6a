#!/bin/sh
# Every tm_*.h of src compiles alone, without a warning:  check-headers.sh c|c++17|c++20|nvcc
# So it does with pair arithmetic in single (TM_PAIR_SINGLE), or it says that it is double only.
set -eu
. "$(dirname -- "$0")/common.sh"

warnings='-fopenmp-simd -Wall -Wextra -Wpedantic -Wno-unused-function -Werror'
case ${1:-} in
  c)   compile="${CC:-cc} -std=c11 $warnings -Wc++-compat -x c -fsyntax-only" ;;
  c++17|c++20) compile="${CXX:-c++} -std=$1 $warnings -x c++ -fsyntax-only" ;;
  nvcc)
    PATH=$PATH:/usr/local/cuda/bin
    command -v nvcc > /dev/null || { echo "skipped: no nvcc here"; exit 77; }
    compile="nvcc -x cu -ptx -arch=sm_90 -diag-suppress 177 -Werror all-warnings -o /dev/null" ;;
  *) die "check-headers.sh c|c++17|c++20|nvcc" ;;
esac

cd "$root"
folders=$(find src -type d -printf ' -I%p')
headers=$(find src -name 'tm_*.h' | sort)
echo "$headers" | xargs -P "$jobs" -I{} sh -c "$compile $folders {} || { echo 'fails: {}'; exit 1; }"
compile_single="$compile -DTM_PAIR_SINGLE $folders"
if [ "$1" = nvcc ]; then
  $compile_single src/PAIR_SPH_TM/particle/tm_rates.h    # all that the GPU's loops in single include
else
  echo "$headers" | xargs -P "$jobs" -I{} sh -c "said=\$($compile_single -Wfatal-errors {} 2>&1) && exit 0
    case \$said in *'\"double only: '*) exit 0 ;; esac
    echo \"\$said\"; echo 'fails in single: {}'; exit 1"
fi
echo "$(echo "$headers" | wc -l) headers compile alone with $compile"
