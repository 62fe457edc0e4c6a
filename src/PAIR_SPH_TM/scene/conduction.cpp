#include "conduction.h"

#include "particle_state.h"
#include "step_results.h"

#include "atom.h"

#include <algorithm>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

Conduction::Conduction(LAMMPS *lmp, Pair *p, Backend &where, StepResults &r) :
    Pointers(lmp), pair(p), backend(where), loops(PairLoops::of(where)), results(r)
{
  for (auto *a : {&index, &count}) a->live_in(where);
  for (auto *a : {&g, &capacity, &power, &first, &F[0], &F[1], &T[0], &T[1]}) a->live_in(where);
}

void Conduction::set_rows(const tm_rows &m, const tm_rows &o)
{
  mechanical = m;
  others = o;
}

void Conduction::make_room(tm_conduct_args &a)
{
  const size_t own = (size_t) atom->nlocal + 1, all = own + atom->nghost;
  const size_t width = std::max(loops.conduct_room(backend, atom->nlocal, a, 0u), 1);
  for (auto *v : {&capacity, &power, &first, &F[0], &F[1]}) v->make_room(true, own);
  for (auto *v : {&T[0], &T[1]}) v->make_room(true, all);
  count.make_room(true, own);
  index.make_room(true, own * width);
  g.make_room(true, own * width);
  a.rows.by_column = !backend.shared();
  a.rows.width = a.rows.by_column ? (ptrdiff_t) own : (ptrdiff_t) width;
  a.rows.index = index.loop_write();
  a.rows.count = count.loop_write();
  a.rows.g = g.loop_write();
  a.capacity = capacity.loop_write();
  a.power = power.loop_write();
  a.first = first.loop_write();
}

// temperatures of a stage to the ghosts
void Conduction::communicate(LoopArray<tm_real> &values) { results.communicate(pair, values, 1); }

void Conduction::advance(ParticleState &state)
{
  const int n = atom->nlocal;
  tm_conduct_args a = {};
  a.rates = results.rate_args();
  a.rates.rows = mechanical;
  a.others = others;
  a.state = state.arrays();
  a.held = state.source().held.args();
  a.source = state.heat_source();
  a.dt = state.time_step().now();
  make_room(a);
  a.F = F[0].loop_write();
  a.older = F[1].loop_write();
  a.T_new = T[0].loop_write();

  Backend &those = state.active().stepping();
  const double mine = loops.conduct_row(those, n, a, state.effects());
  double rate;
  MPI_Allreduce(&mine, &rate, 1, MPI_DOUBLE, MPI_MAX, world);
  const int s = last_stages = tm_rkl_stages(rate * a.dt);
  for (int j = 1; j <= s; j++) {
    LoopArray<tm_real> &last = T[(j - 1) % 2], &next = T[j % 2];
    communicate(last);
    a.T = last.loop_read();
    a.T_new = next.loop_write();
    a.F = F[(j - 1) % 2].loop_write();
    a.older = F[j % 2].loop_write();
    a.stage = tm_rkl_stage(j, s);
    a.c = tm_rkl_time(j, s);
    a.is_first = j == 1;
    loops.conduct_stage(those, n, a, 0u);
  }
  a.T = T[s % 2].loop_read();
  a.F = F[s % 2].loop_write();
  const tm_conduct_result r = loops.conduct_end(those, n, a, 0u);
  state.source().held.take_supply(r.supply);
  const double local[3] = {-r.lowest, r.highest, r.change};
  double all[3];
  MPI_Allreduce(local, all, 3, MPI_DOUBLE, MPI_MAX, world);
  state.time_step().set_heat_error(all[0] + all[1] > 0.0 ? 0.5 * all[2] / (all[0] + all[1]) : 0.0);
}

}    // namespace SPHTM_NS
