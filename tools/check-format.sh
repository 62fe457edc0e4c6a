#!/bin/sh
# src is laid out as .clang-format says; skipped without clang-format 14, as other versions differ.
set -eu
. "$(dirname -- "$0")/common.sh"

for format in clang-format-14 clang-format ''; do
  [ -n "$format" ] || { echo "skipped: no clang-format 14 here"; exit 77; }
  case $("$format" --version 2> /dev/null) in *'version 14.'*) break ;; esac
done
cd "$root"
files=$(find src -name '*.h' -o -name '*.c' -o -name '*.cpp')
echo "$files" | xargs "$format" --dry-run -Werror || die "run: $format -i FILE..."
echo "$(echo "$files" | wc -l) files are laid out as .clang-format says"
