#!/bin/sh
# Compiler launcher for LAMMPS with CUDA:  nvcc-where-needed.sh nvcc_wrapper ARGS... -c FILE
# Nine tenths of LAMMPS's files see no Kokkos: those go straight to the host compiler, in a third of the time. A build that
# happens once needs no dependency files either, for which nvcc_wrapper starts nvcc a second time.
compiler=$1; shift
n=$#
while [ "$n" -gt 0 ]; do
  case $1 in
    -MD) ;;
    -MT|-MF) shift; n=$((n - 1)) ;;
    *) set -- "$@" "$1" ;;
  esac
  file=$1
  shift; n=$((n - 1))
done
case $file in
  *.cpp) grep -qiE 'kokkos|"style_' "$file" || set -- --host-only "$@" ;;
esac
exec "$compiler" "$@"
