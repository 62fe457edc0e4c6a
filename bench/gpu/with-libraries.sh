#!/bin/sh
# bin/lmp and bin/mpirun of a bundle: the program of that name with the libraries and the Open MPI of the bundle
here=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
export LD_LIBRARY_PATH="$here/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
export OPAL_PREFIX="$here/mpi" PMIX_INSTALL_PREFIX="$here/mpi/pmix2"
# one machine without network: ranks share memory, and a rank by itself needs no daemon
export OMPI_MCA_btl=self,vader OMPI_MCA_btl_vader_single_copy_mechanism=none OMPI_MCA_ess_singleton_isolated=1
export OMPI_MCA_plm=isolated OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
# ranks on several GPUs send from one's memory to another's
device_mpi=$here/lib/libdevice_mpi.so
if [ "${0##*/}" = lmp ] && [ -f "$device_mpi" ]; then export LD_PRELOAD="$device_mpi${LD_PRELOAD:+:$LD_PRELOAD}"; fi
exec "$here/libexec/${0##*/}" "$@"
