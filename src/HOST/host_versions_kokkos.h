/* SPH-TM: names and values of LAMMPS's KOKKOS package that differ between its versions. */
#ifndef SPHTM_HOST_VERSIONS_KOKKOS_H
#define SPHTM_HOST_VERSIONS_KOKKOS_H

#include "kokkos_base.h"
#include "kokkos_type.h"

namespace SPHTM_NS {

// buffers of the communication, as the functions have them that are overridden
template <class METHOD> struct BufferOf;
template <class BUFFER> struct BufferOf<void (LAMMPS_NS::KokkosBase::*)(int, int, BUFFER &)> {
  using type = BUFFER;
};
template <class BUFFER, class... REST>
struct BufferOf<void (LAMMPS_NS::KokkosBase::*)(BUFFER &, DAT::tdual_int_1d &, REST...)> {
  using type = BUFFER;
};
using ForwardBuffer = BufferOf<decltype(&LAMMPS_NS::KokkosBase::unpack_forward_comm_kokkos)>::type;
using ExchangeBuffer = BufferOf<decltype(&LAMMPS_NS::KokkosBase::unpack_exchange_kokkos)>::type;

// Newer versions tell the host's arrays from those that Kokkos has there
inline bool on_host(LAMMPS_NS::ExecutionSpace space) { return space != LAMMPS_NS::Device; }

// does LAMMPS exchange particles on the host? Newer versions have another word for it.
template <class COMM> auto exchange_on_host(COMM &comm) -> decltype((comm.exchange_comm_classic))
{
  return comm.exchange_comm_classic;
}
template <class COMM> auto exchange_on_host(COMM &comm) -> decltype((comm.exchange_comm_legacy))
{
  return comm.exchange_comm_legacy;
}

}    // namespace SPHTM_NS

#endif
