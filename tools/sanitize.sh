#!/bin/sh
# The C tests and some scenes under the address and undefined-behavior sanitizers of gcc:
#   sanitize.sh [SCENE...]      scenes as in unittest/scenes, without test_; default: those below
# Only the plugin is instrumented, and its rate loops only once, for this processor; LAMMPS and MPI are not, and leaks are
# looked for in the C tests only.
set -eu
. "$(dirname -- "$0")/common.sh"

"$root/tools/packages.sh" demo
host=$("$root/tools/host-plain.sh")
[ $# -gt 0 ] || set -- materials contact_output contact_tools contact_bodies contact_books heat_contact heat_surface drive \
  restart rings runtime_stops effects between_runs restart_adapt tool_checks tool_files faults

build=$root/build/sanitize
[ $lammps = 20250204 ] || build=$build-$lammps
flags='-g1 -O1 -fno-omit-frame-pointer -fsanitize=address,undefined'
flags="$flags -fno-sanitize=vptr,object-size,pointer-overflow,null -fno-sanitize-recover=undefined"    # address sees those too
make_folder "$build"
lock sanitize
[ -f "$build/build.ninja" ] ||
  cmake -S "$root" -B "$build" -G Ninja -D LAMMPS_SOURCE_DIR="$(cat "$host/source")" -D LAMMPS_BUILD_DIR="$host" \
    -D SPHTM_NATIVE=ON -D CMAKE_BUILD_TYPE=None -D CMAKE_C_FLAGS="$flags" -D CMAKE_CXX_FLAGS="$flags" > "$build/configure.log" 2>&1 ||
  { cat "$build/configure.log" >&2; rm -f "$build/build.ninja"; die "CMake failed"; }
tests=$(cd "$root/unittest/c" && for file in test_*.c; do echo "${file%.c}"; done)
thin_ninja "$build/build.log" -C "$build" sphtmplugin $tests || die "the build failed"

# The sanitizer must be there before the program that loads the plugin. A script that it stops looks to a test like one with
# an error message, so that every finding in the plugin is kept. (Open MPI 4.1 reads freed memory of its own in MPI_Abort.)
libasan=$(${CC:-cc} -print-file-name=libasan.so) libubsan=$(${CC:-cc} -print-file-name=libubsan.so)
cat > "$build/lmp" <<END
#!/bin/sh
LD_PRELOAD="$libasan $libubsan" "$host/lmp" "\$@" 2> "$build/stderr.\$\$"
status=\$?
cat "$build/stderr.\$\$" >&2
grep -qE 'runtime error|AddressSanitizer' "$build/stderr.\$\$" &&
  grep -qE 'runtime error|sphtmplugin|sphtm_styles|$root/src/' "$build/stderr.\$\$" && mv "$build/stderr.\$\$" "$build/report.\$\$"
rm -f "$build/stderr.\$\$"
exit \$status
END
chmod +x "$build/lmp"
use_host "$build" "$build"
rm -f "$build"/report.*
export UBSAN_OPTIONS=print_stacktrace=1
failed=

say "C tests"
for test in $tests; do
  "$build/unittest/$test" > "$build/$test.log" 2>&1 || failed="$failed $test"
done
say "scenes: $*"
for scene; do
  ASAN_OPTIONS=detect_leaks=0 PYTHONDONTWRITEBYTECODE=1 \
    /usr/bin/python3 "$root/unittest/scenes/test_$scene.py" > "$build/$scene.log" 2>&1 || failed="$failed $scene"
done

for report in "$build"/report.*; do
  [ -f "$report" ] || continue
  grep -h -m 1 -E 'runtime error|Sanitizer' "$report"
  failed="$failed ${report##*/}"
done
[ -z "$failed" ] || { echo "something failed, see $build:$failed"; exit 1; }
echo "nothing found in $(echo $tests | wc -w) C tests and $# scenes"
