#!/bin/sh
# Installs what is missing of the Debian packages that a command needs; does nothing when all are there.
#   packages.sh demo|identify|manual|package|test|effects|bench|all [list]      list: only prints those that are missing
set -eu
. "$(dirname -- "$0")/common.sh"

demo='build-essential cmake ninja-build pkg-config libopenmpi-dev openmpi-bin libpng-dev libjpeg-dev zlib1g-dev
  xz-utils ca-certificates debian-archive-keyring python3 python3-numpy python3-matplotlib'
identify="$demo python3-scipy"
manual='python3 python3-sphinx python3-sphinx-rtd-theme libjs-mathjax'
deb="$demo dpkg-dev file"    # CPack tells programs from other files by file
test="$identify $manual libgtest-dev libgmock-dev libyaml-dev"
effects="$demo valgrind"
bench="$test libeigen3-dev"
all="$bench liggghts clang libclang-rt-14-dev imagemagick"    # tests that want these skip without them

case ${1:-demo} in
  demo) wanted=$demo ;;
  identify) wanted=$identify ;;
  manual) wanted=$manual ;;
  package) wanted=$deb ;;
  test) wanted=$test ;;
  effects) wanted=$effects ;;
  bench) wanted=$bench ;;
  all) wanted=$all ;;
  *) die "packages.sh demo|identify|manual|package|test|effects|bench|all" ;;
esac

if ! command -v apt-get > /dev/null; then
  [ "${2:-}" != list ] || exit 0
  tools='c++ cmake ninja mpirun /usr/bin/python3'
  [ "${1:-demo}" != manual ] || tools=/usr/bin/python3
  for tool in $tools; do
    command -v $tool > /dev/null || die "not a Debian system, and there is no $tool: install what is the like of" $wanted
  done
  exit 0
fi

missing=
for package in $wanted; do
  case " $missing " in *" $package "*) continue ;; esac
  case $(dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2> /dev/null) in
    ii*) ;;
    *) missing="$missing $package" ;;
  esac
done
[ "${2:-}" != list ] || { echo "$missing"; exit 0; }
[ -n "$missing" ] || exit 0

if [ "$(id -u)" = 0 ]; then sudo=
elif command -v sudo > /dev/null; then sudo=sudo
else die "not root, and no sudo: have these Debian packages installed, then try again:$missing"
fi
say "installing$missing"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
wait='-o DPkg::Lock::Timeout=600'
$sudo apt-get -q $wait -o APT::Update::Error-Mode=any update > "$log" 2>&1 ||
  { tail -n 20 "$log" >&2; say "apt-get update had trouble$(cause_in "$log"); going on"; }
$sudo env DEBIAN_FRONTEND=noninteractive apt-get -q -y $wait install --no-install-recommends $missing > "$log" 2>&1 ||
  { tail -n 20 "$log" >&2; die "apt-get could not install$missing$(cause_in "$log")"; }
