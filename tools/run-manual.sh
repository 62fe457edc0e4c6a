#!/bin/sh
# The manual as HTML, from doc/ with Sphinx, into out/manual. Every warning fails the build.
#   run-manual.sh [FOLDER]      FOLDER: another place, which must be empty or hold an earlier manual
set -eu
. "$(dirname -- "$0")/common.sh"

"$root/tools/packages.sh" manual
out=${1:-$root/out/manual}
make_way "$out"
make_folder "$out"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
/usr/bin/python3 -m sphinx -q -b html -n -W --keep-going -d "$out/.doctrees" "$root/doc" "$out" > "$log" 2>&1 ||
  { cat "$log" >&2; die "the manual has warnings"; }
rm -rf "$out/.doctrees"
say "open $out/index.html in a browser"
echo "$out/index.html"
