#!/bin/sh
# Removes what ./sphtm made in build/ and out/;  clean.sh all  also the LAMMPS source and hosts in the cache.
# That is what carries a mark (see common.sh) and is not in use; all else stays, and is named. Links are not followed.
set -eu
. "$(dirname -- "$0")/common.sh"

# works another sphtm with this lock?
held() { is_plain "$1" && command -v flock > /dev/null && ! flock -n "$1" true; }
is_lock() { is_plain "$1" && case $1 in *.lock) [ "$(head -n 1 "$1")" = "$lock_text" ] ;; *) false ;; esac; }
in_use() {
  case $1 in
    "$root/build/sanitize"*) held "$cache/sanitize.lock" ;;
    "$root/build/"*) held "$cache/$(build_lock "$1").lock" ;;
    *) false ;;
  esac
}
# a file of ours with its mark
file_mark() { echo "${1%/*}/.${1##*/}$mark"; }
is_marked_file() {
  is_plain "$1" && is_plain "$(file_mark "$1")" &&
    (cd "${1%/*}" && sha256sum --check --status ".${1##*/}$mark" 2> /dev/null)
}
is_mark() {
  case ${1##*/} in
    "$mark") return 0 ;;
    .*"$mark") file=${1##*/.}; [ -e "${1%/*}/${file%"$mark"}" ] ;;
    *) return 1 ;;
  esac
}
# as earlier versions named what they made in the cache
is_old() {
  case ${1##*/} in
    host-*) [ -f "$1/lmp" ] && [ -f "$1/source" ] ;;
    lammps-*) [ -f "$1/src/version.h" ] ;;
    *.lock) is_plain "$1" && [ ! -s "$1" ] ;;
    *) return 1 ;;
  esac
}

# quoted for a shell
quoted() { printf "'%s'" "$(printf '%s' "$1" | sed "s/'/'\\\\''/g")"; }

# What stays is said at the end of its folder: stays WHY PATH
n_left=0
stays() {
  n_left=$((n_left + 1))
  [ $n_left -gt 10 ] || say "left $2: $1"
}
# take PATH: removes it where it is ours
take() {
  if [ -L "$1" ]; then stays "a link, which is not followed" "$1"
  elif is_marked "$1"; then
    if in_use "$1"; then stays "another sphtm works in it" "$1"
    else rm -rf -- "$1" || stays "it could not be removed" "$1"
    fi
  elif is_lock "$1"; then rm -f -- "$1" || stays "it could not be removed" "$1"
  elif is_marked_file "$1"; then rm -f -- "$1" "$(file_mark "$1")" || stays "it could not be removed" "$1"
  elif [ -e "$1" ] && ! is_mark "$1"; then
    if is_old "$1"; then stays "made by a sphtm that left no mark; to remove it: rm -r $(quoted "$1")" "$1"
    else stays "it carries no mark of ./sphtm" "$1"
    fi
  fi
}

# take_in FOLDER: what is ours there, and the folder where nothing is left of it
take_in() {
  n_left=0
  for path in "$1"/* "$1"/.[!.]* "$1"/..?*; do take "$path"; done
  [ $n_left -le 10 ] || say "left $((n_left - 10)) more in $1"
}

case ${1:-} in
  ''|all) ;;
  *) die "clean.sh [all]" ;;
esac
for folder in "$root/build" "$root/out"; do
  if [ -L "$folder" ]; then say "left $folder: a link, which is not followed"
  elif [ -d "$folder" ]; then
    take_in "$folder"
    rmdir "$folder" 2> /dev/null || true
  fi
done
[ "${1:-}" = all ] || exit 0

name_cache
[ -d "$cache" ] || exit 0
for lock in "$cache"/*.lock; do
  if is_lock "$lock" && held "$lock"; then
    say "left $cache: another sphtm works there (${lock##*/})"
    exit 0
  fi
done
take_in "$cache"
if [ $n_left -eq 0 ] && is_plain "$cache/$mark" && [ "$(head -n 1 "$cache/$mark")" = "$cache_text" ]; then
  rm -f "$cache/$mark"
  rmdir "$cache" 2> /dev/null || true    # a link to a folder stays
fi
