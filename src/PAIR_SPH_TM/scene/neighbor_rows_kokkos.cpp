#ifdef LMP_KOKKOS
#include "neighbor_rows_kokkos.h"

#include "backend_kokkos.h"
#include "model.h"

#include "atom_kokkos.h"
#include "atom_masks.h"
#include "neigh_list_kokkos.h"
#include "pair.h"

#include <algorithm>
#include <cstdlib>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

static const ExecutionSpace SPACE = ExecutionSpaceFromDevice<LMPDeviceType>::space;

NeighborRowsKokkos::NeighborRowsKokkos(LAMMPS *lmp, Pair *pair, Backend &loops, Model &m) :
    NeighborRows(lmp, pair, loops, m), atoms((AtomKokkos *) atom)
{
  with_thermal.live_in(loops);
  with_thermal.call("rows of neighbors");
}

const int *NeighborRowsKokkos::loop_tags()
{
  static_assert(sizeof(tagint) == sizeof(int), "neighbor rows sort by tags of 32 bits (SMALLBIG)");
  atoms->sync(SPACE, TAG_MASK);
  return atoms->k_tag.view<LMPDeviceType>().data();
}

tm_rows NeighborRowsKokkos::loop_rows()
{
  tm_rows rows = NeighborRows::loop_rows();
  if (in_list) rows.index = in_list;
  if (lists_thermal) {
    rows.with_thermal = with_thermal.loop_read();
    rows.n_with_thermal = n_with_thermal;
  }
  return rows;
}

tm_rows NeighborRowsKokkos::host_rows()
{
  tm_rows rows = NeighborRows::host_rows();
  if (source() || !in_list) return rows;
  if (list_here.empty()) {
    list_here.resize(list_size);
    backend.to_host(list_here.data(), in_list, list_size * sizeof(int));
  }
  rows.index = list_here.data();
  return rows;
}

// rows of so many values would take too much of what is left: records, rates and LAMMPS's buffers come too
bool NeighborRowsKokkos::memory_is_short(double values) const
{
  if (getenv("SPHTM_ROWS_IN_LIST")) return true;    // for tests
  return values > row_index.size() && 4.0 * values * sizeof(int) > backend.free_memory();
}

namespace {

struct CountRow {
  tm_row_args a;
  KOKKOS_FUNCTION void operator()(int i) const { tm_row_count(i, &a); }
};
struct HasThermal {
  const int *thermal;
  KOKKOS_FUNCTION bool operator()(int i) const { return thermal[i] > 0; }
};
struct PlaceRows {
  tm_row_args a;
  int n;
  KOKKOS_FUNCTION void operator()(int slice, ptrdiff_t &begin, bool last) const
  {
    if (last)
      for (int i = slice * TM_ROW_SLICE; i < n && i < (slice + 1) * TM_ROW_SLICE; i++)
        a.first[i] = begin + i % TM_ROW_SLICE;
    begin += tm_row_slice_size(slice, n, &a);
  }
};
struct FillRow {
  tm_row_args a;
  KOKKOS_FUNCTION void operator()(int i) const { tm_row_fill(i, &a); }
};

// on a GPU a warp sorts a row: it holds the entries, and each thread finds the places of some
struct FillRowByWarp {
  using Team = Kokkos::TeamPolicy<LMPDeviceType>;
  using Entries =
      Kokkos::View<tm_row_entry *, LMPDeviceType::scratch_memory_space, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;
  tm_row_args a;
  int n, longest, rows;    // entries of the longest row, rows per team

  KOKKOS_FUNCTION void operator()(const Team::member_type &team) const
  {
    const int i = team.league_rank() * rows + team.team_rank();
    if (i >= n) return;
    const Entries entries(team.thread_scratch(0), longest);
    tm_row_entry *entry = entries.data();
    const int m = a.length[i];
    Kokkos::parallel_for(Kokkos::ThreadVectorRange(team, m), [&](int k) { entry[k] = tm_row_load(i, k, &a); });
    Kokkos::parallel_for(Kokkos::ThreadVectorRange(team, m), [&](int k) { tm_row_put(i, k, m, entry, &a); });
  }
  static bool fits(int longest) { return Entries::shmem_size(longest) <= MEMORY; }
  void run()
  {
    const size_t scratch = Entries::shmem_size(longest);
    rows = std::max(1, std::min(MAX_ROWS, (int) (MEMORY / scratch)));
    Kokkos::parallel_for("sph/tm fill rows",
                         Team((n + rows - 1) / rows, rows, 32).set_scratch_size(0, Kokkos::PerThread(scratch)), *this);
  }
  static constexpr size_t MEMORY = 32000;    // bytes of a team, which every GPU has
#if defined(LMP_KOKKOS_GPU)
  static constexpr int MAX_ROWS = 4;
#else
  static constexpr int MAX_ROWS = 1;
#endif
};

}    // namespace

void NeighborRowsKokkos::leave_list()
{
  in_list = nullptr;
  list_here = {};
  lists_thermal = false;
}

void NeighborRowsKokkos::build(RowSearch &finder, const int *which, int n, bool conduction)
{
  leave_list();
  NeighborRows::build(finder, which, n, conduction);
}

void NeighborRowsKokkos::build(NeighList *list, bool conduction)
{
  const int n = atom->nlocal;
  const std::vector<unsigned char> segments = model.pair_laws().segments(model.materials(), conduction);
  meets.assign(segments.data(), segments.size());
  make_room();
  row_stride = TM_ROW_SLICE;
  leave_list();
  row_index.make_room(true, 1);
  if (n == 0) return;

  atoms->sync(SPACE, TYPE_MASK | TAG_MASK);
  const auto *from = static_cast<NeighListKokkos<LMPDeviceType> *>(list);
  tm_row_args a;
  a.list = from->d_neighbors.data();
  a.length = from->d_numneigh.data();
  a.row_step = from->d_neighbors.stride(0);
  a.step = from->d_neighbors.stride(1);
  a.bits = NEIGHMASK;
  a.meets = meets.loop_read();
  a.type = atoms->k_type.view<LMPDeviceType>().data();
  a.tag = atoms->k_tag.view<LMPDeviceType>().data();
  a.ntypes = model.types();
  a.count[0] = row_mechanical.loop_write();
  a.count[1] = row_thermal.loop_write();
  a.count[2] = row_contact.loop_write();
  a.first = row_first.loop_write();
  const int longest = from->d_neighbors.extent(1);
  const bool by_warps = !backend.shared() && FillRowByWarp::fits(longest);
  const bool in_two = std::any_of(segments.begin(), segments.end(), [](int s) { return s & (s - 1); });
  list_size = from->d_neighbors.span();
  // entries have no bits of bonds
  a.in_place = by_warps && !in_two && atom->molecular == Atom::ATOMIC && memory_is_short((double) list_size);
  kokkos_each("sph/tm count rows", n, CountRow{a});
  lists_thermal = conduction && model.pair_laws().has_thermal();
  if (lists_thermal) {    // some of the particles: those of a tool, and beside it
    with_thermal.make_room(true, n);
    n_with_thermal =
        kokkos_list("sph/tm rows with heat", n, HasThermal{row_thermal.loop_read()}, with_thermal.loop_write());
  }
  if (a.in_place) {
    row_index.clear();
    a.index = in_list = from->d_neighbors.data();
    a.stride = row_stride = a.step;
    FillRowByWarp{a, n, longest, 1}.run();
    return;
  }
  ptrdiff_t total = 0;
  Kokkos::parallel_scan("sph/tm place rows",
                        Kokkos::RangePolicy<LMPDeviceType>(0, (n + TM_ROW_SLICE - 1) / TM_ROW_SLICE), PlaceRows{a, n},
                        total);
  row_index.make_room(true, total);
  a.index = row_index.loop_write();
  a.stride = TM_ROW_SLICE;
  if (by_warps) FillRowByWarp{a, n, longest, 1}.run();
  else kokkos_each("sph/tm fill rows", n, FillRow{a});
}

}    // namespace SPHTM_NS
#endif
