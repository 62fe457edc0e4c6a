#!/bin/sh
# One archive that runs tests, bench and profile on a machine with a GPU and no internet: out/gpu-bundle.tar.xz
#   gpu-bundle.sh [cuda|openmp]       openmp: the same for a machine without GPU, to try the bundle itself
# It needs Kokkos as host-kokkos.sh does, and Open MPI, which goes along. With no Kokkos it exits with 77.
set -eu
. "$(dirname -- "$0")/common.sh"

devices=${1:-cuda}
case $devices in cuda|openmp) ;; *) die "gpu-bundle.sh [cuda|openmp]" ;; esac
limit=60    # MiB, of the archive

"$root/tools/packages.sh" demo
case $(mpirun_command) in *oversubscribe*) ;; *) die "the bundle carries Open MPI, and mpirun here is another" ;; esac
plain_host=$("$root/tools/host-plain.sh")
plain_plugin=$("$root/tools/build-plugin.sh" "$plain_host")
host=$("$root/tools/host-kokkos.sh" "$devices")
plugin=$("$root/tools/build-plugin.sh" "$host")

name=gpu-bundle
[ $devices = cuda ] || name=$devices-bundle
mkdir -p "$root/build"
work=$(mktemp -d "$root/build/bundle.XXXXXX")
make_folder "$work"
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
top=$work/$name
mkdir -p "$top/bin" "$top/lib" "$top/libexec" "$top/plugin" "$top/bench/gpu" "$top/scenes" "$top/mpi/share"

say "programs and libraries"
cp "$root"/bench/gpu/*.py "$root/unittest/kokkos/stops.py" "$top/bench/gpu/"
cp "$root/bench/gpu/run" "$top/run"
cp -R "$root/materials" "$top/"
echo "$devices" > "$top/devices"
git -C "$root" describe --always --dirty > "$top/version" 2> /dev/null || echo unknown > "$top/version"
${CC:-cc} -std=c11 -D_POSIX_C_SOURCE=199309L -O2 -shared -fPIC "$root/bench/gpu/kernel_table.c" -o "$top/lib/libkernel_table.so"
cp "$host/lmp" "$top/libexec/lmp"
cp "$(command -v orterun)" "$top/libexec/mpirun"
cp "$plugin/sphtmplugin.so" "$plugin/sphtm_styles.so" "$top/plugin/"
strip --strip-unneeded "$top"/plugin/*.so
if [ $devices = cuda ]; then
  toolkit=$(dirname -- "$(dirname -- "$(readlink -f "$(command -v nvcc || echo /usr/local/cuda/bin/nvcc)")")")
  mpicc -std=c11 -O2 -Wall -Wextra -shared -fPIC "-I$toolkit/include" "$root/tools/device-mpi/device_mpi.c" \
    -o "$top/lib/libdevice_mpi.so" "-L$toolkit/lib64" -lcudart
  kokkos=$(sed -n 's/^Kokkos_DIR:[A-Z]*=//p' "$host/CMakeCache.txt")
  arch=$(sed -n 's/^set(Kokkos_ARCH .*[A-Z]\([0-9]*\))$/sm_\1/p' "$kokkos/KokkosConfigCommon.cmake")
  "$root/tools/device-test.sh" "$top/libexec/device" ${arch:-}
fi
for program in lmp mpirun; do cp "$root/bench/gpu/with-libraries.sh" "$top/bin/$program"; done

# Open MPI's components, without those for networks and batch systems that a single machine does not have
mpi_lib=$(ompi_info --path pkglibdir --parsable | cut -d : -f 3)
mpi_prefix=$(ompi_info --path prefix --parsable | cut -d : -f 3)
cp -R "$(ompi_info --path pkgdatadir --parsable | cut -d : -f 3)" "$top/mpi/share/openmpi"
pmix=$(ldd "$mpi_lib"/mca_pmix_ext*.so 2> /dev/null | sed -n 's/.*libpmix\.so.* => \(.*\) (0x.*/\1/p' | head -n 1)
foreign='ucp|ucs|uct|fabric|ibverbs|rdmacm|psm|oshmem|slurm|flux|lustre|java|not found'
components() {    # FROM TO
  mkdir -p "$2"
  for component in "$1"/*.so; do
    ldd "$component" 2> /dev/null | grep -qE "$foreign" || cp "$component" "$2/"
  done
}
components "$mpi_lib" "$top/mpi${mpi_lib#"$mpi_prefix"}"
[ -z "$pmix" ] || components "$(dirname -- "$(readlink -f "$pmix")")/pmix" "$top/mpi/pmix2/lib/pmix"

# every library that these ask for, but those of any Linux with a C++ compiler, and the driver's
base='linux-vdso|ld-linux|lib(c|m|dl|rt|pthread|resolv|util|gcc_s|stdc\+\+|gomp|cuda)\.so'
find "$top" -type f \( -name '*.so' -o -path '*/libexec/*' \) | { cat; echo "$host/liblammps.so.0"; } |
  while IFS= read -r file; do LD_LIBRARY_PATH=$host ldd "$file" 2> /dev/null; done |
  sed -n 's/^[[:space:]]*\([^ ]*\) => \(\/.*\) (0x.*/\1 \2/p' | grep -vE "^($base)" | sort -u -k 1,1 |
  while read -r soname path; do cp -L "$path" "$top/lib/$soname"; done
strip --strip-unneeded "$top"/lib/*.so* 2> /dev/null || true

say "scenes"
python3 "$root/bench/gpu/scenes.py" | while read -r scene script; do
  mkdir "$top/scenes/$scene"
  cp "$root/$script" "$top/scenes/$scene/"
  folder=$root/${script%/*}
  for mesh in "$folder"/*.stl; do [ ! -f "$mesh" ] || cp "$mesh" "$top/scenes/$scene/"; done
done
tool() { /usr/bin/python3 "$root/tools/make_tool.py" "$@" > /dev/null; }
tool block --size 40 40 10 --cells 20 20 5 --scale 1e-3 -o "$top/scenes/contact/tool.stl"
cp "$top/scenes/contact/tool.stl" "$top/scenes/contact_mixed/"
tool plane --size 1 1 --cells 2 2 -o "$top/scenes/taylor_bar/plane.stl"
/usr/bin/python3 "$root/examples/taylor_bar/make_bar.py" 3 3.2e-3 32.4e-3 8930 "$top/scenes/taylor_bar/bar.data" \
  > "$top/scenes/taylor_bar/spacing"
/usr/bin/python3 "$root/examples/rings/make_rings.py" "$top/scenes/rings/rings.data"

say "sweeps of ./run accuracy, cuts of ./run validate"
# the same folders as in the repository: sweeps find scripts and references there
for file in bench/study.py bench/provenance.py bench/many.py bench/shared_gpu.py bench/accuracy bench/stability bench/validate tools/make_tool.py \
  unittest/scenes/sphtm_scene.py unittest/scenes/sph_kernels.py unittest/scenes/test_spinning_block.py \
  $(sed -n 's/.*"\(unittest\)", "\(scenes\)", "\(test_[a-z_]*\.py\)".*/\1\/\2\/\3/p' "$root"/bench/accuracy/*.py | sort -u) \
  $(sed -n 's/.*\(example\|script_of\)("\([a-z0-9_]*\)".*/examples\/\2/p' "$root"/bench/accuracy/*.py "$root"/bench/validate/case_*.py | sort -u); do
  mkdir -p "$top/${file%/*}"
  cp -R "$root/$file" "$top/${file%/*}/"
done
find "$top/examples" "$top/bench" -name '*.png' -o -name '*.gif' -o -name 'log.*' -o -name '__pycache__' | xargs rm -rf

say "expected results, of the plain styles on this machine"
use_host "$plain_host" "$plain_plugin"
SPHTM_BUNDLE=$top SPHTM_DEVICES=plain SPHTM_MATERIALS=$root/materials PYTHONDONTWRITEBYTECODE=1 \
  /usr/bin/python3 "$top/bench/gpu/run.py" reference --out "$work/reference" >&2

mkdir -p "$root/out"
tar -C "$work" -cJf "$work/$name.tar.xz" "$name"
size=$(($(stat -c %s "$work/$name.tar.xz") / 1048576))
[ $size -lt $limit ] || die "the archive has $size MiB, more than $limit"
mv "$work/$name.tar.xz" "$root/out/$name.tar.xz"
mark_file "$root/out/$name.tar.xz"
say "$size MiB; on the other machine: tar -xf $name.tar.xz && $name/run test"
echo "$root/out/$name.tar.xz"
