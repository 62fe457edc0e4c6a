#!/bin/sh
# 10 s of the mesh fuzzer, for ctest; exits 77 (skipped) without clang's libFuzzer. Inputs that break it are kept.
work=$(mktemp -d "${TMPDIR:-/tmp}/sphtm-fuzz-XXXXXX")
status=0
"$(dirname "$0")/../../tools/fuzz.sh" 10 "$work" || status=$?
[ "$status" -eq 1 ] || rm -rf "$work"
exit "$status"
