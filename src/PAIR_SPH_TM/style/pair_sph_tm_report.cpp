/* SPH-TM: pair style sph/tm, numbers of neighbors and memory, for output and the table of the run. */
#include "pair_sph_tm.h"

#include "fix_sph_tm.h"

#include "atom.h"

using namespace LAMMPS_NS;

tm_near_args PairSPHTM::near_args(bool of_each)
{
  near_count.make_room(of_each, (size_t) atom->nlocal + 1);
  tm_near_args a;
  a.rows = args.rows;
  a.main = rec.main;
  a.reach2 = rec.size ? args.support2 : args.reach2;
  a.size = rec.size;
  a.count = near_count.loop_write();
  return a;
}

double PairSPHTM::neighbors(bool of_each)
{
  const bool rows = args.reach2 && args.rows.first;
  return loops.near_count(backend, rows ? atom->nlocal : 0, near_args(of_each), 0);
}

const tm_real *PairSPHTM::loop_neighbors()
{
  neighbors(true);
  return near_count.loop_read();
}

tm_nearest PairSPHTM::nearest() { return loops.nearest(backend, atom->nlocal, near_args(false), 0); }

std::map<unsigned, double> PairSPHTM::bytes_by_effect() const
{
  std::map<unsigned, double> bytes;
  bytes[0] = rec_main.bytes() + gradient.bytes();
  for (auto *a : {&single_main, &single_more, &single_correction, &single_size}) bytes[0] += a->bytes();
  bytes[TM_FX_ARTSTRESS] = rec_stress.bytes();
  bytes[TM_FX_HEAT] = rec_heat.bytes();
  bytes[TM_FX_CONDUCTION] = heat.bytes();
  bytes[TM_FX_CORRECTION] = rec_correction.bytes() + correction.bytes();
  bytes[TM_FX_SMOOTHING] = rec_size.bytes();
  bytes[TM_FX_XSPH] = xsph_v.bytes();
  bytes[TM_FX_HOURGLASS] = rec_hourglass.bytes() + hourglass_rate.bytes();
  bytes[TM_FX_SURFACE] = surface.bytes();
  bytes[TM_FX_LEDGER] = force_internal.bytes();
  bytes[fix->has(TM_FX_LEDGER) ? TM_FX_LEDGER : TM_FX_ENERGY] += artificial.bytes();
  return bytes;
}

double PairSPHTM::bytes_of_rows() const
{
  double bytes = row_index.bytes() + row_first.bytes();
  for (auto *a : {&row_mechanical, &row_thermal, &row_contact}) bytes += a->bytes();
  return bytes;
}

double PairSPHTM::memory_usage()
{
  double bytes = Pair::memory_usage() + bytes_of_rows();
  if (!has_fix()) return bytes;
  for (const auto &b : bytes_by_effect()) bytes += b.second;
  return bytes;
}
