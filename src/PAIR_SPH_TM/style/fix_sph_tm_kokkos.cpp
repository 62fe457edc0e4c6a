/* SPH-TM: fix sph/tm with Kokkos. See doc/fix_sph_tm.rst. */
#ifdef LMP_KOKKOS
#include "fix_sph_tm_kokkos.h"

#include "backend_kokkos.h"

#include "atom_kokkos.h"
#include "atom_masks.h"
#include "comm_kokkos.h"
#include "lammps.h"
#include "modify.h"
#include "region.h"
#include "utils.h"

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

namespace {

// the rows of all fields in use, as one row of values per particle
struct StateRows {
  double *row[TM_F_COUNT];
  int columns[TM_F_COUNT], fields = 0, width = 0;

  StateRows(ParticleFields &f)
  {
    for (int id = 0; id < TM_F_COUNT; id++) {
      if (f[id].empty()) continue;
      row[fields] = f[id].loop_write();
      columns[fields] = tm_field_table[id].columns;
      width += columns[fields++];
    }
  }
  KOKKOS_FUNCTION double *at(int k, int i) const { return row[k] + tm_row(i, columns[k]); }
  KOKKOS_FUNCTION void pack(int i, double *buf) const
  {
    for (int k = 0; k < fields; k++)
      for (int c = 0; c < columns[k]; c++) *buf++ = at(k, i)[tm_column(c)];
  }
  KOKKOS_FUNCTION void unpack(int i, const double *buf) const
  {
    for (int k = 0; k < fields; k++)
      for (int c = 0; c < columns[k]; c++) at(k, i)[tm_column(c)] = *buf++;
  }
  KOKKOS_FUNCTION void copy(int from, int to) const
  {
    for (int k = 0; k < fields; k++)
      for (int c = 0; c < columns[k]; c++) at(k, to)[tm_column(c)] = at(k, from)[tm_column(c)];
  }
};

// sent particles leave, others take their places
struct Pack {
  StateRows rows;
  const int *sent, *filled_by;
  double *buf;
  KOKKOS_FUNCTION void operator()(int k) const
  {
    rows.pack(sent[k], buf + (ptrdiff_t) k * rows.width);
    if (filled_by[k] >= 0) rows.copy(filled_by[k], sent[k]);
  }
};
struct Unpack {
  StateRows rows;
  const int *place;    // or -1: not for this rank
  const double *buf;
  KOKKOS_FUNCTION void operator()(int k) const
  {
    if (place[k] >= 0) rows.unpack(place[k], buf + (ptrdiff_t) k * rows.width);
  }
};

// rows in the order of a sort, and back to where they belong
template <class ORDER> struct Sort {
  const double *rows;
  ORDER from;
  Kokkos::View<double *, LMPDeviceType> sorted;
  int columns;
  KOKKOS_FUNCTION void operator()(int i) const
  {
    for (int c = 0; c < columns; c++)
      sorted((size_t) i * columns + c) = rows[tm_row((int) from(i), columns) + tm_column(c)];
  }
};
struct Sorted {
  double *rows;
  Kokkos::View<double *, LMPDeviceType> sorted;
  int columns;
  KOKKOS_FUNCTION void operator()(int i) const
  {
    for (int c = 0; c < columns; c++) rows[tm_row(i, columns) + tm_column(c)] = sorted((size_t) i * columns + c);
  }
};

constexpr auto ATOM_DATA = X_MASK | V_MASK | F_MASK | TYPE_MASK | MASK_MASK | RMASS_MASK;
const ExecutionSpace SPACE = ExecutionSpaceFromDevice<LMPDeviceType>::space;

class KokkosAtomArrays : public AtomArrays {
 public:
  explicit KokkosAtomArrays(LAMMPS *lmp) : AtomArrays(lmp), atoms((AtomKokkos *) lmp->atom) {}
  void point_to(tm_state &s) override
  {
    atoms->sync(SPACE, ATOM_DATA);
    s.x = atoms->k_x.view<LMPDeviceType>().data();
    s.v = atoms->k_v.view<LMPDeviceType>().data();
    s.force = atoms->k_f.view<LMPDeviceType>().data();
    s.type = atoms->k_type.view<LMPDeviceType>().data();
    s.mask = atoms->k_mask.view<LMPDeviceType>().data();
    s.mass = atom->mass ? atoms->k_mass.view<LMPDeviceType>().data() : nullptr;
    s.rmass = atom->rmass_flag ? atoms->k_rmass.view<LMPDeviceType>().data() : nullptr;
  }
  void velocities_changed() override { atoms->modified(SPACE, V_MASK); }
  // LAMMPS has blocks and spheres where the loops run; others are asked on the host
  const int *inside(Region &region) override
  {
    if ((int) matches.extent(0) <= atom->nlocal) matches = DAT::tdual_int_1d("sph/tm: in region", atom->nmax + 1);
    matches.clear_sync_state();
    region.prematch();
    if (auto *there = dynamic_cast<KokkosBase *>(&region)) there->match_all_kokkos(1, matches);
    else {
      atoms->sync(Host, X_MASK);
      match(region, matches.view<LMPHostType>().data());
      matches.modify<LMPHostType>();
    }
    matches.sync<LMPDeviceType>();
    return matches.view<LMPDeviceType>().data();
  }
  // what the loops have changed is known to LAMMPS only at the end of a step
  void to_host_in_step() override
  {
    atoms->modified(SPACE, X_MASK | V_MASK);
    atoms->sync(Host, ALL_MASK);
  }
  void to_host() override { atoms->sync(Host, ALL_MASK); }
  void host_changed() override
  {
    atoms->modified(Host, ALL_MASK);
    atoms->sync(SPACE, ALL_MASK);
  }

 private:
  AtomKokkos *atoms;
  DAT::tdual_int_1d matches;
};

}    // namespace

FixSPHTMKokkos::FixSPHTMKokkos(LAMMPS *lmp, int narg, char **arg) :
    FixSPHTM(lmp, narg, arg, kokkos_backend(), std::make_unique<KokkosAtomArrays>(lmp))
{
  kokkosable = 1;
  atomKK = (AtomKokkos *) atom;
  execution_space = ExecutionSpaceFromDevice<LMPDeviceType>::space;
  datamask_read = ATOM_DATA;
  datamask_modify = X_MASK | V_MASK;
  exchange_comm_device = sort_device = 1;
}

void FixSPHTMKokkos::init()
{
  FixSPHTM::init();
  if (atom->mass) {
    atomKK->k_mass.modify_host();
    atomKK->k_mass.sync_device();
  }
  // LAMMPS takes a fix without a Kokkos version for one that changes all that atoms have. These only read, and nothing
  // has to go back to a GPU after each of their turns; see also fixes_of_host_kokkos.h.
  for (Fix *f : modify->get_fix_list())
    if (!f->kokkosable && utils::strmatch(f->style, "^ave/")) f->datamask_modify = EMPTY_MASK;
}

// checks of the set-up look at particles on the host
void FixSPHTMKokkos::setup(int vflag)
{
  exchange_as_before();
  atomKK->sync(Host, ALL_MASK);
  FixSPHTM::setup(vflag);
}

// With one rank LAMMPS exchanges nothing where the loops run, and keeps particles that have left the box: its bins then
// write beyond their end. On the host it deletes them.
void FixSPHTMKokkos::delete_lost()
{
  auto *brick = dynamic_cast<CommKokkos *>(comm);
  if (!brick || comm->nprocs > 1 || exchange_on_host(*brick)) return;
  exchange_on_host(*brick) = exchanges_on_host = true;
}

void FixSPHTMKokkos::exchange_as_before()
{
  if (exchanges_on_host) exchange_on_host(*static_cast<CommKokkos *>(comm)) = false;
  exchanges_on_host = false;
}

void FixSPHTMKokkos::setup_pre_exchange() { delete_lost(); }

void FixSPHTMKokkos::pre_exchange()
{
  FixSPHTM::pre_exchange();
  if (leaves) delete_lost();
}

void FixSPHTMKokkos::post_neighbor()
{
  exchange_as_before();
  FixSPHTM::post_neighbor();
}

/* ---------------------------------------------------------------------- */

int FixSPHTMKokkos::pack_exchange_kokkos(const int &nsend, ExchangeBuffer &k_buf, DAT::tdual_int_1d k_sendlist,
                                         DAT::tdual_int_1d k_copylist, ExecutionSpace space)
{
  k_sendlist.sync<LMPDeviceType>();
  k_copylist.sync<LMPDeviceType>();
  const StateRows rows(state.fields());
  kokkos_each("sph/tm send", nsend,
              Pack{rows, k_sendlist.view<LMPDeviceType>().data(), k_copylist.view<LMPDeviceType>().data(),
                   k_buf.view<LMPDeviceType>().data()});
  if (on_host(space)) {
    k_buf.modify<LMPDeviceType>();
    k_buf.sync<LMPHostType>();
  }
  return nsend * rows.width;
}

void FixSPHTMKokkos::unpack_exchange_kokkos(ExchangeBuffer &k_buf, DAT::tdual_int_1d &k_indices, int nrecv, int, int,
                                            ExecutionSpace space)
{
  if (on_host(space)) {
    k_buf.modify<LMPHostType>();
    k_buf.sync<LMPDeviceType>();
  }
  k_indices.sync<LMPDeviceType>();
  kokkos_each("sph/tm receive", nrecv,
              Unpack{StateRows(state.fields()), k_indices.view<LMPDeviceType>().data(),
                     k_buf.view<LMPDeviceType>().data()});
}

void FixSPHTMKokkos::sort_kokkos(Kokkos::BinSort<KeyViewType, BinOp> &sorter)
{
  auto from = sorter.get_permute_vector();
  const int n = from.extent(0);
  for (int id = 0; id < TM_F_COUNT; id++) {
    if (state.fields()[id].empty()) continue;
    const int columns = tm_field_table[id].columns;
    double *rows = state.fields()[id].loop_write();
    const Kokkos::View<double *, LMPDeviceType> sorted(Kokkos::ViewAllocateWithoutInitializing("sph/tm sorted"),
                                                       (size_t) n * columns);
    kokkos_each("sph/tm sort", n, Sort<decltype(from)>{rows, from, sorted, columns});
    kokkos_each("sph/tm sorted", n, Sorted{rows, sorted, columns});
  }
}
#endif
