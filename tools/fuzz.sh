#!/bin/sh
# Feeds mutated mesh files to the mesh readers under address and undefined-behavior sanitizers:
#   tools/fuzz.sh [seconds] [folder]      default 600 s; found inputs and the grown corpus stay in the folder
# The corpus starts from unittest/meshes. Needs clang with libFuzzer (Debian: clang, libclang-rt-dev).
# Exits 77 where there is none, 1 when an input was found that breaks the readers.
set -eu
seconds=${1:-600}
top=$(cd "$(dirname "$0")/.." && pwd)
work=${2:-$(mktemp -d "${TMPDIR:-/tmp}/sphtm-fuzz-XXXXXX")}
mkdir -p "$work/corpus" "$work/found"
clang=${CLANG:-clang}
flags="-std=c11 -g -O1 -fno-omit-frame-pointer -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=undefined"
includes=$(find "$top/src" -type d -printf ' -I%p')
if ! echo 'int LLVMFuzzerTestOneInput(const char *d, unsigned long n) { return d && n > 9; }' |
    $clang $flags -w -x c - -o "$work/probe" > "$work/probe.log" 2>&1; then
  echo "no clang with libFuzzer here (see $work/probe.log): skipped"
  exit 77
fi
$clang $flags $includes "$top/unittest/fuzz/fuzz_mesh.c" $(find "$top/src/FIX_CONTACT_TRI" -name '*.c') -lm -o "$work/fuzz_mesh"
status=0
nice "$work/fuzz_mesh" -max_total_time="$seconds" -max_len=8192 -timeout=20 -rss_limit_mb=1500 \
  -print_final_stats=1 -artifact_prefix="$work/found/" "$work/corpus" "$top/unittest/meshes" \
  > "$work/log" 2>&1 || status=1
grep -E 'stat::|cov:.*DONE|ERROR|SUMMARY' "$work/log" | tail -12
if [ "$status" -ne 0 ]; then
  echo "found: $(ls "$work/found"); log: $work/log"
  exit 1
fi
echo "nothing found in $seconds s"
