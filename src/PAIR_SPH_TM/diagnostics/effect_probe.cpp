#include "effect_probe.h"

#include "effect_plan.h"
#include "scene.h"
#include "step_args.h"
#include "run_clock.h"

#include <algorithm>

namespace SPHTM_NS {

// Time of this thread alone where it runs the loops: on a busy machine wall time would be that of others.
static double probe_time(const Backend &loops) { return loops.shared() ? RunClock::processor_time() : RunClock::now(); }

EffectProbe::EffectProbe(ParticleState &s, StepResults &r, int particles) :
    particles_state(s), results(r), loops(s.loops()), n(particles)
{
  const unsigned fx = particles_state.effects();
  const size_t block = loops.block(), rows = (n + block - 1) / block * block;    // whole blocks are copied
  auto room = [&](LoopArray<double> &a, bool wanted, int columns, int together = 1) {
    a.live_in(loops, columns, together);
    if (wanted) a.resize(rows * columns);
  };
  auto plain = [&](LoopArray<double> &a, bool wanted, int columns) {
    a.live_in(loops);
    if (wanted) a.resize((size_t) n * columns);
  };
  for (int id = 0; id < TM_F_COUNT; id++)
    room(state[id], particles_state.arrays().field[id] != nullptr, tm_field_table[id].columns);
  room(main, true, TM_REC, 2);
  room(stress, fx & TM_FX_ARTSTRESS, TM_REC_STRESS, 2);
  plain(size, fx & TM_FX_SMOOTHING, TM_REC_SIZE);
  plain(hourglass, fx & TM_FX_HOURGLASS, TM_REC_HOURGLASS);
  room(gradient, true, 9);
  plain(x, true, 3);
  plain(v, true, 3);
  plain(heat_record, fx & TM_FX_HEAT, TM_REC_HEAT);
  plain(force, true, 3);
  plain(heat, fx & TM_FX_CONDUCTION, 1);
  plain(xsph_v, fx & TM_FX_XSPH, 3);
  room(uneven, fx & TM_FX_SHIFTING, 3);
  plain(surface, fx & TM_FX_SURFACE, 3);
  room(stab, fx & TM_FX_ONE_PASS, TM_REC_STAB, 2);
  room(moment, fx & TM_FX_ONE_PASS, TM_MOMENT_COLUMNS);
  room(correction, fx & TM_FX_CORRECTION, 6);
  room(turn, fx & TM_FX_FACES, 3);
  room(face_next, fx & TM_FX_FACES, TM_FACE_COLUMNS);
  plain(artificial, results.rate_args().artificial != nullptr, 1);
}

// seconds of one step of the sample with these effects, from the same state every time
double EffectProbe::step(const Arguments &of, unsigned fx)
{
  tm_rates_args r = of.rates;
  r.effects = fx;
  r.force = force.loop_write();
  r.gradient = gradient.loop_write();
  r.heat = heat.loop_write();
  r.xsph_v = xsph_v.loop_write();
  r.uneven = fx & TM_FX_SHIFTING ? uneven.loop_write() : nullptr;
  r.surface = surface.loop_write();
  r.artificial = artificial.loop_write();
  r.moment = moment.loop_write();
  r.turn = turn.loop_write();
  r.face_next = face_next.loop_write();

  const tm_state &now = of.state;
  tm_predict_args p = of.predict;
  p.rec = {main.loop_write(), stress.loop_write(),    heat_record.loop_write(), nullptr,
           size.loop_write(), hourglass.loop_write(), stab.loop_write(),        (fx & TM_FX_FACES) != 0};
  p.correction = correction.loop_write();
  p.turn = turn.loop_write();

  tm_update_args u = of.update;
  for (int id = 0; id < TM_F_COUNT; id++) {
    if (state[id].empty()) continue;
    u.state.field[id] = state[id].loop_write();
    loops.copy(u.state.field[id], now.field[id], state[id].bytes());
  }
  u.uneven = r.uneven;
  u.moment = moment.loop_write();
  u.face_next = face_next.loop_write();
  u.state.x = x.loop_write();
  u.state.v = v.loop_write();
  loops.copy(u.state.x, now.x, x.bytes());
  loops.copy(u.state.v, now.v, v.bytes());
  if (!(fx & TM_FX_HEAT)) u.source = nullptr;

  loops.wait();
  const double begin = probe_time(loops);
  const PairLoops &run = PairLoops::of(loops);
  Backend &those = particles_state.active().stepping();
  run.predict(those, n, p, fx);
  run.rates(those, n, r, fx);
  run.update(those, n, u, fx);
  loops.wait();
  return probe_time(loops) - begin;
}

std::map<unsigned, double> EffectProbe::shares(int rounds)
{
  // an effect is taken away after those that need it
  const unsigned all = particles_state.effects();
  std::map<unsigned, std::pair<unsigned, unsigned>> sets;    // effect -> with, without
  std::map<unsigned, double> least = {{all, 1e300}};
  for (const unsigned bit : effects_in_loops()) {
    if (!(all & bit)) continue;
    unsigned with = all;
    if (bit == TM_FX_HEAT)
      with &= ~unsigned(TM_FX_CONDUCTION | TM_FX_EXPANSION | TM_FX_COMPRESSION_HEAT | TM_FX_ARTIFICIAL_HEAT);
    if (bit == TM_FX_VISCOSITY) with &= ~unsigned(TM_FX_BALSARA);
    unsigned without = with & ~bit;
    if (bit == TM_FX_CORRECTION) without &= ~(unsigned(TM_FX_ONE_PASS) | TM_FX_HOURGLASS);    // of one pass
    sets[bit] = {with, without};
    least[with] = least[without] = 1e300;
  }
  const tm_state now = particles_state.arrays();
  const Arguments of = {now, results.rate_args(), results.predict_args(particles_state, now),
                        update_args(particles_state, results)};
  for (int k = 0; k < rounds; k++)
    for (auto &l : least) l.second = std::min(l.second, step(of, l.first));
  std::map<unsigned, double> share;
  for (const auto &s : sets) share[s.first] = (least[s.second.first] - least[s.second.second]) / least[all];
  return share;
}

}    // namespace SPHTM_NS
