#!/bin/sh
# The .deb in a bare Debian: debootstrap of the release this machine runs, in a folder of its own, from the mirror that apt
# uses here; the package is installed without what it only recommends, and a user without rights cuts metal with it.
#   check-package.sh [--lammps]      --lammps: with Debian's own lammps beside it, which does not fit
# Without root, debootstrap or a mirror it exits with 77. Mounts are in a namespace that ends with the script.
set -eu
. "$(dirname -- "$0")/common.sh"

skip() { echo "skipped: $*"; exit 77; }
if [ "${SPHTM_UNSHARED:-}" != yes ]; then
  [ "$(id -u)" = 0 ] || skip 'needs root'
  for tool in debootstrap apt-get unshare dpkg-shlibdeps; do command -v $tool > /dev/null || skip "no $tool here"; done
  unshare --mount true 2> /dev/null || skip 'no mount namespaces here'
  SPHTM_UNSHARED=yes exec unshare --mount --propagation private "$0" "$@"
fi
release=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
mirror=$(apt-get indextargets --format '$(ORIGIN)|$(LABEL)|$(COMPONENT)|$(IDENTIFIER)|$(REPO_URI)' |
  sed -n 's/^Debian|Debian|main|Packages|//p' | head -n 1)
[ -n "$mirror" ] && [ -n "$release" ] || skip 'apt knows no Debian mirror here'

package=$("$root/tools/package.sh")
work=$(mktemp -d)
trap 'umount -l "$work/system/proc" "$work/system/dev/shm" 2> /dev/null || true; rm -rf --one-file-system "$work"' EXIT
trap 'exit 130' INT TERM
there=$work/system

quiet() { "$@" > "$work/log" 2>&1 || { tail -n 30 "$work/log"; die "failed: $*$(cause_in "$work/log")"; }; }
inside() { chroot "$there" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive LC_ALL=C "$@"; }
as_user() {
  chroot --userspec=tester "$there" env -i PATH=/usr/bin:/bin HOME=/home/tester LC_ALL=C sh -euc "cd; $1"
}
holds() { echo "ok    $*"; }

say "debootstrap of $release"
quiet debootstrap --variant=minbase "$release" "$there" "$mirror"
cp /etc/resolv.conf "$there/etc/" 2> /dev/null || true
mount -t proc proc "$there/proc"
mount -t tmpfs tmpfs "$there/dev/shm" 2> /dev/null || true
cp "$package" "$there/tmp/sphtm.deb"
quiet inside apt-get -q update
say 'installing'
quiet inside apt-get -q -y --no-install-recommends install /tmp/sphtm.deb
quiet inside useradd -m tester
holds "$(basename -- "$package") installs with $(inside dpkg-query -f . -W | wc -c) packages in all"

# nothing of it points to the checkout
inside dpkg -L sphtm | while IFS= read -r file; do
  [ ! -f "$there$file" ] || ! grep -qF -- "$root/" "$there$file" || die "$file names $root"
done
for file in $(inside dpkg -L sphtm | grep '/sphtm.*\.so$'); do
  ! grep -qF -- "$cache/" "$there$file" || die "$file names $cache"
done
holds 'no file names the source'

as_user 'sphtm doctor' > "$work/doctor" || { cat "$work/doctor"; die 'doctor sees no run that can start'; }
grep -q 'missing *Python *numpy' "$work/doctor" && grep -q 'apt-get install python3-numpy' "$work/doctor" ||
  { cat "$work/doctor"; die 'doctor does not miss numpy'; }
holds 'doctor: a run can start; numpy is missing, and how to get it'
! as_user 'sphtm demo' > "$work/demo" 2>&1 && grep -q 'python3-numpy' "$work/demo" || die 'demo does not say what it needs'
! as_user 'sphtm test' > "$work/demo" 2>&1 && grep -q 'source tree' "$work/demo" || die 'test does not say that it needs the source'
holds 'demo names what it needs, test says that it is for the source tree'

# the same as in the log that comes with the example, to its first rows
cut='cp /usr/share/sphtm/examples/orthogonal_cut_2d/* . && sed -i "s/^run .*/run 8000/" in.orthogonal_cut_2d'
rows() {    # without the last column, the time left
  awk '$1 == "Step" { on = 1; next } /^Loop/ { on = 0 }
       on && $1 ~ /^(0|4000|8000)$/ && !seen[$1]++ { print $1, $2, $3, $4, $5, $6 }' "$1"
}
as_user "mkdir cut; cd cut; $cut; sphtm lmp -in in.orthogonal_cut_2d" > "$work/cut" 2>&1 || { tail "$work/cut"; die 'the cut failed'; }
rows "$there/home/tester/cut/log.lammps" > "$work/rows"
rows "$root/examples/orthogonal_cut_2d/log.orthogonal_cut_2d" > "$work/expected"
[ "$(wc -l < "$work/rows")" = 3 ] && paste "$work/rows" "$work/expected" | awk '
  { n = NF / 2; for (k = 1; k <= n; k++) { d = $k - $(n + k); if (d < 0) d = -d; s = $k < 0 ? -$k : $k
      if (d > 1e-6 * s + 1e-12) { print "row " NR ", column " k ": " $k " is not " $(n + k); bad = 1 } } }
  END { exit bad }' || die 'the cut differs from its log'
holds "a user cuts Ti6Al4V, $(grep -c . "$there/home/tester/cut/force.dat") rows of forces, as in the log of the example"

say 'installing what it recommends'
quiet inside apt-get -q -y --no-install-recommends install python3-numpy python3-matplotlib
as_user 'eval "$(sphtm env)"; cd cut; $SPHTM_MPIRUN -np 2 "$SPHTM_LMP" -in in.orthogonal_cut_2d -log log.two' > "$work/two" 2>&1 ||
  { tail "$work/two"; die 'two ranks failed'; }
grep -q 'on 2 procs' "$there/home/tester/cut/log.two" || die 'no two ranks'
as_user 'sphtm stability --quick --cases rest' > "$work/study" 2>&1 || { tail "$work/study"; die 'a study failed'; }
[ -n "$(ls "$there/home/tester/out/stability")" ] || die 'a study left no results'
holds 'two ranks, and a study with its results in out/ of the current folder'
as_user 'sphtm validate layers --quick' > "$work/study" 2>&1 || { tail "$work/study"; die 'sphtm validate failed'; }
as_user 'sphtm demo --spacing 0.5' > "$work/study" 2>&1 || { tail "$work/study"; die 'sphtm demo failed'; }
[ -s "$there/home/tester/out/validate/summary.json" ] && [ -s "$there/home/tester/out/demo/summary.json" ] ||
  die 'demo or validate left no results'
holds 'demo and validate'

if [ "${1:-}" = --lammps ]; then
  quiet inside apt-get -q -y --no-install-recommends install lammps
  as_user 'SPHTM_LMP=/usr/bin/lmp sphtm lmp' > "$work/other" 2>&1 && die "sphtm runs Debian's lammps, which cannot fit"
  grep '^sphtm:' "$work/other"
  as_user 'sphtm doctor' > "$work/doctor"
  grep LAMMPS "$work/doctor"
  grep -q 'unfit *LAMMPS */usr/bin/lmp' "$work/doctor" || die "doctor takes Debian's lammps"
  holds "Debian's lammps is not taken, and a run can start"
fi

quiet inside apt-get -q -y purge sphtm
left=$(inside find / -xdev -name '*sphtm*' -not -path '/proc/*' -not -path '/home/*' -not -path '/tmp/*' -not -path '/var/*')
[ -z "$left" ] || die "left behind: $left"
holds 'nothing is left after purge'
