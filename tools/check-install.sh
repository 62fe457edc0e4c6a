#!/bin/sh
# What is built installs into a prefix, works there after it has moved, and names no folder of this machine:
#   check-install.sh BUILD
set -eu
. "$(dirname -- "$0")/common.sh"

build=${1:?usage: check-install.sh BUILD}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
unset LAMMPS_PLUGIN_PATH SPHTM_MATERIALS SPHTM_SOURCE SPHTM_BUILD
cmake --install "$build" --prefix "$work/first" > "$work/log" || { cat "$work/log"; die 'cmake --install failed'; }
cmake --install "$build" --prefix "$work/first" --component host >> "$work/log" || { cat "$work/log"; die 'no host installed'; }
mv "$work/first" "$work/moved it"
there="$work/moved it"

named=$(grep -rlF -e "$root/" -e "$build" "$there" || true)
[ -z "$named" ] || die "they name the source or the build: $named"
for file in "$there"/lib*/lammps/plugins/*.so "$there"/lib*/*/lammps/plugins/*.so; do
  [ ! -f "$file" ] || ! grep -qF -e /home/ -e "${HOME:-/nowhere}/" -e "$cache/" "$file" || die "$file names a folder of this machine"
done
echo 'ok    no file names the source or the build'
[ -z "$(find "$there" -name '__pycache__' -o -name 'log.lammps' -o -name '*.sphtm-made')" ] || die 'leftovers are installed'

cd "$work"
[ -f "$there"/lib/sphtm/lmp ] || [ -f "$there"/lib/*/sphtm/lmp ] || SPHTM_LMP=${SPHTM_LMP:?no lmp to run}
if [ -f "$there/lib/sphtm/lmp" ]; then unset SPHTM_LMP; fi
"$there/bin/sphtm" doctor > doctor || { cat doctor; die 'doctor sees no run that can start'; }
grep -q "$there" doctor || die 'doctor looks elsewhere'
cp "$there"/share/sphtm/examples/orthogonal_cut_2d/* .
sed -i 's/^run .*/run 10/' in.orthogonal_cut_2d
# a card is found from the plugin's folder, also after the script has gone elsewhere
sed -i 's/^pair_coeff/shell cd \/tmp\npair_coeff/; s/^fix  *tool/shell cd "'"$(echo "$work" | sed 's,/,\\/,g')"'"\n&/' in.orthogonal_cut_2d
"$there/bin/sphtm" lmp -in in.orthogonal_cut_2d > out 2>&1 || { tail out; die 'a run failed'; }
echo 'ok    doctor, and a run with a card and a mesh, in a prefix that has moved'
"$there/bin/sphtm" tool plane --size 1 1 --cells 1 1 -o plane.stl > /dev/null
[ -s plane.stl ] || die 'no mesh of a tool'
echo 'ok    the mesh of a tool'

# demo and validate, from elsewhere: what they make is below the current folder, and nothing in the prefix changes
mkdir "$work/user"
cd "$work/user"
touch "$work/stamp"
for command in 'demo --spacing 0.5' 'validate layers --quick'; do
  "$there/bin/sphtm" $command > "$work/out" 2>&1 || { tail "$work/out"; die "sphtm $command failed"; }
done
grep -q '"force_ratio_heat_over_no_heat"' out/demo/summary.json && [ -s out/demo/forces.csv ] || die 'no results of the demo'
[ "$(find out/demo -name '*.png' | wc -l)" -ge 4 ] || die 'no pictures of the demo'
grep -q '"ratio_1000"' out/validate/summary.json && [ -s out/validate/layers.png ] || die 'no results of validate'
[ ! -e "$work/user/log.lammps" ] || die 'a log lies in the current folder'
changed=$(find "$there" -newer "$work/stamp")
[ -z "$changed" ] || die "they write into the prefix: $changed"
SPHTM_OUT=elsewhere "$there/bin/sphtm" validate layers --quick --rows ratio_1 > "$work/out" 2>&1 && [ -s elsewhere/summary.json ] ||
  { tail "$work/out"; die 'a relative SPHTM_OUT is not of the current folder'; }
cp "$there/share/sphtm/examples/two_layer_heat/in.two_layer_heat" .
"$there/bin/sphtm" many in.two_layer_heat --vary n=50,100 > "$work/out" 2>&1 && [ "$(wc -l < out/many/summary.csv)" = 3 ] ||
  { tail "$work/out"; die 'sphtm many failed'; }
echo 'ok    demo, validate and many; the prefix is as it was'
