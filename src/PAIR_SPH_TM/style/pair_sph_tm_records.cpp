/* SPH-TM: pair style sph/tm, the records of the particles and how they come to the ghosts. See tm_record.h. */
#include "pair_sph_tm.h"

#include "fix_sph_tm.h"

#include "atom.h"
#include "comm.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

void PairSPHTM::resize_arrays()
{
  const size_t all = (size_t) atom->nlocal + atom->nghost + 1, own = (size_t) atom->nlocal + 1;
  rec_main.make_room(true, all * TM_REC);
  rec_stress.make_room(fix->has(TM_FX_ARTSTRESS), all * TM_REC_STRESS);
  rec_heat.make_room(fix->has(TM_FX_HEAT), all * TM_REC_HEAT);
  rec_correction.make_room(fix->has(TM_FX_CORRECTION), all * TM_REC_CORRECTION);
  rec_size.make_room(fix->has(TM_FX_SMOOTHING), all * TM_REC_SIZE);
  rec_hourglass.make_room(fix->has(TM_FX_HOURGLASS), all * TM_REC_HOURGLASS);
  gradient.make_room(true, own * 9);
  heat.make_room(fix->has(TM_FX_CONDUCTION), own);
  correction.make_room(fix->has(TM_FX_CORRECTION), own * 6);
  xsph_v.make_room(fix->has(TM_FX_XSPH), own * 3);
  hourglass_rate.make_room(fix->has(TM_FX_HOURGLASS), own * 3);
  surface.make_room(fix->has(TM_FX_SURFACE), own * 3);
  artificial.make_room(fix->has(TM_FX_LEDGER) || fix->has(TM_FX_ENERGY), own);
  force_internal.make_room(fix->has(TM_FX_LEDGER), own * 3);
  rec.main = rec_main.loop_write();
  rec.stress = rec_stress.loop_write();
  rec.heat = rec_heat.loop_write();
  rec.correction = rec_correction.loop_write();
  rec.size = rec_size.loop_write();
  rec.hourglass = rec_hourglass.loop_write();
}

tm_records PairSPHTM::host_records()
{
  tm_records r;
  r.main = const_cast<tm_real *>(rec_main.host_read());
  r.stress = const_cast<tm_real *>(rec_stress.host_read());
  r.heat = const_cast<tm_real *>(rec_heat.host_read());
  r.correction = const_cast<tm_real *>(rec_correction.host_read());
  r.size = const_cast<tm_real *>(rec_size.host_read());
  r.hourglass = const_cast<tm_real *>(rec_hourglass.host_read());
  return r;
}

tm_rows PairSPHTM::host_rows()
{
  if (row_source) return row_source->host_mechanical();
  return {row_index.host_read(),   row_first.host_read(),   row_mechanical.host_read(),
          row_thermal.host_read(), row_contact.host_read(), row_stride};
}

tm_predict_args PairSPHTM::predict_args(const tm_state &s)
{
  tm_predict_args a;
  a.state = s;
  a.rec = rec;
  a.dt_ahead = fix->time_ahead();
  a.art_eps = set.art_eps;
  a.art_component = set.art_component;
  a.share = tensile_shares();
  a.ratio = set.ratio;
  a.hourglass = set.hourglass;
  a.gradient = tables.gradient.loop_read();
  return a;
}

void PairSPHTM::predict(const tm_state &s)
{
  const auto timed = fix->run_clock.timed(RunClock::PREDICT);
  loops.predict(backend, atom->nlocal, predict_args(s), fix->effects());
}

int PairSPHTM::forward_columns() const
{
  return TM_REC - 3 + (rec.stress ? TM_REC_STRESS : 0) + (rec.heat ? TM_REC_HEAT : 0) +
      (rec.size ? TM_REC_SIZE : 0);
}

void PairSPHTM::forward_records()
{
  const auto timed = fix->run_clock.timed(RunClock::COMMUNICATION);
  comm->forward_comm(this, forward_columns());
  take_ghost_positions();
}

void PairSPHTM::take_ghost_positions()
{
  double **x = atom->x;
  for (int i = atom->nlocal; i < atom->nlocal + atom->nghost; i++)
    std::copy_n(x[i], 3, rec.main + (size_t) i * TM_REC);
}

void PairSPHTM::forward(LoopArray<tm_real> &values, int columns)
{
  forwarded = &values;
  forwarded_columns = columns;
  comm->forward_comm(this, columns);
  forwarded = nullptr;
}

// only what travels is brought to the host and back
int PairSPHTM::pack_forward_comm(int n, int *sendlist, double *buf, int, int *)
{
  double *start = buf;
  auto put = [&](const tm_real *from, size_t j, int columns) {
    if (from) buf = std::copy_n(from + j * columns, columns, buf);
  };
  if (forwarded) {
    const tm_real *from = forwarded->host_read();
    for (int k = 0; k < n; k++) put(from, sendlist[k], forwarded_columns);
    return (int) (buf - start);
  }
  const tm_real *main = rec_main.host_read(), *stress = rec_stress.host_read(), *heat = rec_heat.host_read();
  const tm_real *size = rec_size.host_read();
  for (int k = 0; k < n; k++) {
    buf = std::copy_n(main + (size_t) sendlist[k] * TM_REC + 3, TM_REC - 3, buf);
    put(stress, sendlist[k], TM_REC_STRESS);
    put(heat, sendlist[k], TM_REC_HEAT);
    put(size, sendlist[k], TM_REC_SIZE);
  }
  return (int) (buf - start);
}

void PairSPHTM::unpack_forward_comm(int n, int first, double *buf)
{
  auto get = [&](tm_real *to, size_t j, int columns) {
    if (!to) return;
    std::copy_n(buf, columns, to + j * columns);
    buf += columns;
  };
  if (forwarded) {
    tm_real *to = forwarded->host_write();
    for (int j = first; j < first + n; j++) get(to, j, forwarded_columns);
    return;
  }
  tm_real *main = rec_main.host_write(), *stress = rec_stress.host_write(), *heat = rec_heat.host_write();
  tm_real *size = rec_size.host_write();
  for (int j = first; j < first + n; j++) {
    std::copy_n(buf, TM_REC - 3, main + (size_t) j * TM_REC + 3);
    buf += TM_REC - 3;
    get(stress, j, TM_REC_STRESS);
    get(heat, j, TM_REC_HEAT);
    get(size, j, TM_REC_SIZE);
  }
}
