/* SPH-TM: pair style sph/tm with Kokkos. See doc/pair_sph_tm.rst. */
#ifdef LMP_KOKKOS
#include "pair_sph_tm_kokkos.h"

#include "backend_kokkos.h"
#include "fix_sph_tm_kokkos.h"

#include "atom_kokkos.h"
#include "atom_masks.h"
#include "error.h"
#include "neigh_list_kokkos.h"
#include "neigh_request.h"
#include "neighbor_kokkos.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

PairSPHTMKokkos::PairSPHTMKokkos(LAMMPS *lmp) : PairSPHTM(lmp, kokkos_backend()), meets(backend)
{
  kokkosable = 1;
  fuse_force_clear_flag = 1;
  atomKK = (AtomKokkos *) atom;
  execution_space = ExecutionSpaceFromDevice<LMPDeviceType>::space;
  datamask_read = X_MASK | V_MASK | F_MASK | TYPE_MASK | MASK_MASK | TAG_MASK | RMASS_MASK;
  datamask_modify = F_MASK | ENERGY_MASK | VIRIAL_MASK;
}

void PairSPHTMKokkos::init_style()
{
  PairSPHTM::init_style();
  auto *request = neighbor->find_request(this);
  if (!request) {    // rows come from fix adapt/neigh; LAMMPS looks for those that have moved where the particles are
    static_cast<NeighborKokkos *>(neighbor)->device_flag = 1;
    return;
  }
  request->set_kokkos_device(true);
  request->set_kokkos_host(false);
}

const int *PairSPHTMKokkos::loop_tags()
{
  static_assert(sizeof(tagint) == sizeof(int), "neighbor rows sort by tags of 32 bits (SMALLBIG)");
  atomKK->sync(execution_space, TAG_MASK);
  return atomKK->k_tag.view<LMPDeviceType>().data();
}

/* ---------------------------------------------------------------------- rows */

namespace {

struct CountRow {
  tm_row_args a;
  KOKKOS_FUNCTION void operator()(int i) const { tm_row_count(i, &a); }
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

void PairSPHTMKokkos::build_rows()
{
  const int n = atom->nlocal;
  const std::vector<unsigned char> segments = segments_of_types();
  meets.assign(segments.data(), segments.size());
  make_room_for_rows();
  row_stride = TM_ROW_SLICE;
  row_index.make_room(true, 1);
  if (n == 0) return;

  atomKK->sync(execution_space, TYPE_MASK | TAG_MASK);
  const auto *from = static_cast<NeighListKokkos<LMPDeviceType> *>(list);
  tm_row_args a;
  a.list = from->d_neighbors.data();
  a.length = from->d_numneigh.data();
  a.row_step = from->d_neighbors.stride(0);
  a.step = from->d_neighbors.stride(1);
  a.bits = NEIGHMASK;
  a.meets = meets.loop_read();
  a.type = atomKK->k_type.view<LMPDeviceType>().data();
  a.tag = atomKK->k_tag.view<LMPDeviceType>().data();
  a.ntypes = atom_types;
  a.count[0] = row_mechanical.loop_write();
  a.count[1] = row_thermal.loop_write();
  a.count[2] = row_contact.loop_write();
  a.first = row_first.loop_write();
  kokkos_each("sph/tm count rows", n, CountRow{a});
  ptrdiff_t total = 0;
  Kokkos::parallel_scan("sph/tm place rows",
                        Kokkos::RangePolicy<LMPDeviceType>(0, (n + TM_ROW_SLICE - 1) / TM_ROW_SLICE),
                        PlaceRows{a, n}, total);
  row_index.make_room(true, total);
  a.index = row_index.loop_write();
  const int longest = from->d_neighbors.extent(1);
  if (!backend.shared() && FillRowByWarp::fits(longest)) FillRowByWarp{a, n, longest, 1}.run();
  else kokkos_each("sph/tm fill rows", n, FillRow{a});
}

/* ---------------------------------------------------------------------- communication */

namespace {

// what ghosts get: columns of an array, or their records but for the positions
struct Ghost {
  tm_records rec;
  int columns;
  double *values;    // these, or the records
  // columns from the first on of a record
  KOKKOS_FUNCTION static double *take(double *buf, const double *record, int first, int columns)
  {
    for (int c = first; c < columns; c++) *buf++ = record[tm_part(c)];
    return buf;
  }
  KOKKOS_FUNCTION static const double *give(const double *buf, double *record, int first, int columns)
  {
    for (int c = first; c < columns; c++) record[tm_part(c)] = *buf++;
    return buf;
  }
  KOKKOS_FUNCTION void pack(int j, double *buf) const
  {
    if (values) {
      for (int c = 0; c < columns; c++) buf[c] = values[(ptrdiff_t) j * columns + c];
      return;
    }
    buf = take(buf, tm_main_record(&rec, j), 3, TM_REC);
    if (rec.stress) buf = take(buf, tm_stress_record(&rec, j), 0, TM_REC_STRESS);
    if (rec.heat) buf = take(buf, tm_heat_record(&rec, j), 0, TM_REC_HEAT);
    for (int c = 0; rec.size && c < TM_REC_SIZE; c++) *buf++ = rec.size[(ptrdiff_t) j * TM_REC_SIZE + c];
  }
  KOKKOS_FUNCTION void unpack(int j, const double *buf) const
  {
    if (values) {
      for (int c = 0; c < columns; c++) values[(ptrdiff_t) j * columns + c] = buf[c];
      return;
    }
    buf = give(buf, tm_main_record(&rec, j), 3, TM_REC);
    if (rec.stress) buf = give(buf, tm_stress_record(&rec, j), 0, TM_REC_STRESS);
    if (rec.heat) buf = give(buf, tm_heat_record(&rec, j), 0, TM_REC_HEAT);
    for (int c = 0; rec.size && c < TM_REC_SIZE; c++) rec.size[(ptrdiff_t) j * TM_REC_SIZE + c] = *buf++;
  }
  KOKKOS_FUNCTION int width() const { return columns; }
};
struct PackGhosts {
  Ghost ghost;
  const int *list;
  double *buf;
  KOKKOS_FUNCTION void operator()(int k) const { ghost.pack(list[k], buf + (ptrdiff_t) k * ghost.width()); }
};
struct UnpackGhosts {
  Ghost ghost;
  int first;
  const double *buf;
  KOKKOS_FUNCTION void operator()(int k) const
  {
    ghost.unpack(first + k, buf + (ptrdiff_t) k * ghost.width());
  }
};
struct TakePositions {
  double *rec;
  const double *x;
  int first;
  KOKKOS_FUNCTION void operator()(int k) const
  {
    const int i = first + k;
    for (int d = 0; d < 3; d++) rec[tm_record(i, TM_REC) + tm_part(d)] = x[3 * (ptrdiff_t) i + d];
  }
};

}    // namespace

int PairSPHTMKokkos::pack_forward_comm_kokkos(int n, DAT::tdual_int_1d k_sendlist,
                                              DAT::tdual_xfloat_1d &buf, int, int *)
{
  const Ghost ghost{rec, forwarded ? forwarded_columns : forward_columns(),
                    forwarded ? forwarded->loop_write() : nullptr};
  kokkos_each("sph/tm send to ghosts", n,
              PackGhosts{ghost, k_sendlist.view<LMPDeviceType>().data(), buf.view<LMPDeviceType>().data()});
  return n * ghost.width();
}

void PairSPHTMKokkos::unpack_forward_comm_kokkos(int n, int first, DAT::tdual_xfloat_1d &buf)
{
  kokkos_each("sph/tm receive ghosts", n,
              UnpackGhosts{{rec, forwarded ? forwarded_columns : forward_columns(),
                            forwarded ? forwarded->loop_write() : nullptr},
                           first, buf.view<LMPDeviceType>().data()});
}

void PairSPHTMKokkos::take_ghost_positions()
{
  atomKK->sync(execution_space, X_MASK);
  kokkos_each("sph/tm ghost positions", atom->nghost,
              TakePositions{rec_main.loop_write(), atomKK->k_x.view<LMPDeviceType>().data(), atom->nlocal});
}
#endif
