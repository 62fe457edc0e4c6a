#!/bin/sh
# 20 s of the mesh fuzzer, for ctest; exits 77 (skipped) without clang's libFuzzer.
exec "$(dirname "$0")/../../tools/fuzz.sh" 20
