/* SPH-TM: fix adapt/neigh with Kokkos. See doc/fix_adapt_neigh.rst. */
#ifdef LMP_KOKKOS
#include "fix_adapt_neigh_kokkos.h"

#include "backend_kokkos.h"

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

namespace {

template <class ORDER> struct ToInt {
  ORDER from;
  Kokkos::View<int *, LMPDeviceType> to;
  KOKKOS_FUNCTION void operator()(int i) const { to(i) = (int) from(i); }
};

}    // namespace

FixAdaptNeighKokkos::FixAdaptNeighKokkos(LAMMPS *lmp, int narg, char **arg) :
    OnLoopsKokkos<FixAdaptNeigh>(lmp, narg, arg)
{
  exchange_comm_device = sort_device = !parts.on_host();
}

int FixAdaptNeighKokkos::pack_exchange_kokkos(const int &n, ExchangeBuffer &buf, DAT::tdual_int_1d sent,
                                              DAT::tdual_int_1d filled_by, ExecutionSpace space)
{
  sent.sync<LMPDeviceType>();
  filled_by.sync<LMPDeviceType>();
  send_arrays(n, sent.view<LMPDeviceType>().data(), filled_by.view<LMPDeviceType>().data(),
              buf.view<LMPDeviceType>().data());
  if (on_host(space)) {
    buf.modify<LMPDeviceType>();
    buf.sync<LMPHostType>();
  }
  return n * maxexchange;
}

void FixAdaptNeighKokkos::unpack_exchange_kokkos(ExchangeBuffer &buf, DAT::tdual_int_1d &places, int n, int, int,
                                                 ExecutionSpace space)
{
  if (on_host(space)) {
    buf.modify<LMPHostType>();
    buf.sync<LMPDeviceType>();
  }
  places.sync<LMPDeviceType>();
  receive_arrays(n, places.view<LMPDeviceType>().data(), buf.view<LMPDeviceType>().data());
}

void FixAdaptNeighKokkos::sort_kokkos(Kokkos::BinSort<KeyViewType, BinOp> &sorter)
{
  auto from = sorter.get_permute_vector();
  const int n = from.extent(0);
  const Kokkos::View<int *, LMPDeviceType> order(Kokkos::ViewAllocateWithoutInitializing("sph/tm order"), n);
  kokkos_each("sph/tm order", n, ToInt<decltype(from)>{from, order});
  reorder_arrays(n, order.data());
}
#endif
