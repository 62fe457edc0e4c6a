#include "run_table.h"

#include "accuracy_meter.h"
#include "effect_probe.h"
#include "energy_watch.h"
#include "scene.h"

#include "atom.h"
#include "comm.h"
#include "fix.h"
#include "modify.h"
#include "timer.h"
#include "update.h"
#include "utils.h"

#include <algorithm>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

namespace {
constexpr bigint TABLE_STEPS = 10;                            // a shorter run says little about its times
constexpr double PROBE_SHARE = 0.02;                          // of the run that the probe may take
constexpr double PROBE_ALWAYS = 0.05;                         // s it may take in any case
constexpr int PROBE_ROUNDS = 5, PROBE_PARTICLES = 1 << 18;    // a copy of these is made
}    // namespace

RunTable::RunTable(LAMMPS *lmp, const Fix &f, ParticleState &s, const Scene &sc) :
    Pointers(lmp), fix(f), state(s), scene(sc)
{
}

void RunTable::want(bool table, bool waits)
{
  wanted = table;
  state.clock().set_waits(waits);
}

bool RunTable::start_clock()
{
  if (timing) return false;
  timing = true;
  clock_step = update->ntimestep - 1;
  state.clock().restart();
  state.active().restart_clock();
  if (meter) meter->restart();
  return true;
}

bigint RunTable::steps() const { return update->ntimestep - clock_step; }

// of the particles of this rank, by effect; 0: what every scene has. The room that LAMMPS keeps for more
// particles is not counted
std::map<unsigned, double> RunTable::bytes_by_effect()
{
  std::map<unsigned, double> bytes = scene.results().bytes_by_effect(state.effects());
  for (int id = 0; id < TM_F_COUNT; id++) {
    const unsigned field = tm_field_table[id].effects;
    const unsigned of = field == TM_FX_ONE_PASS ? unsigned(TM_FX_CORRECTION) : field;
    if (!state.fields()[id].empty())
      bytes[effect_name(of).empty() ? 0u : of] += (double) atom->nlocal * tm_field_table[id].columns * sizeof(tm_real);
  }
  bytes[TM_FX_HEAT] += state.source().empty() ? 0.0 : (double) atom->nlocal * sizeof(double);
  return bytes;
}

// share of each effect in prediction, rates and update, or nothing where the run was too short
std::map<unsigned, double> RunTable::probe_effects(double seconds, bigint steps)
{
  const double step =
      (state.clock().of(RunClock::PREDICT) + state.clock().of(RunClock::RATES) + state.clock().of(RunClock::UPDATE)) /
      steps;
  const double sample = std::min(1.0, (double) PROBE_PARTICLES / std::max(atom->nlocal, 1));
  int variants = 2;
  for (const unsigned bit : effects_in_loops()) variants += state.has(bit);
  double cost = step * sample * variants, all;
  MPI_Allreduce(&cost, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  const double budget = std::max(PROBE_SHARE * seconds, PROBE_ALWAYS);
  double rounds = all > 0.0 ? std::min(budget / all, (double) PROBE_ROUNDS) : 0.0;
  MPI_Bcast(&rounds, 1, MPI_DOUBLE, 0, world);
  if (rounds < 2.0) return {};    // one round can be disturbed
  std::map<unsigned, double> share;
  const int first = std::min(atom->nlocal, PROBE_PARTICLES);
  int stepped = first;    // those of them that do not sleep
  state.active().stepping().some(stepped);
  if (stepped > 0) share = EffectProbe(state, scene.results(), first).shares((int) rounds);
  for (const unsigned bit : effects_in_loops()) {    // mean over the ranks
    if (!state.has(bit)) continue;
    double mine[2] = {share[bit] * stepped, (double) stepped}, sum[2];
    MPI_Allreduce(mine, sum, 2, MPI_DOUBLE, MPI_SUM, world);
    share[bit] = sum[0] / std::max(sum[1], 1.0);
  }
  return share;
}

void RunTable::print(const EnergyWatch &energy, const std::string &fracture, const std::string &failed)
{
  const bigint steps = this->steps();
  if (!wanted || !timing || steps < TABLE_STEPS || atom->natoms == 0) return;
  state.clock().settle();
  const double total = state.clock().total();
  timing = false;

  // means over the ranks
  auto mean = [this](double mine) {
    double sum;
    MPI_Allreduce(&mine, &sum, 1, MPI_DOUBLE, MPI_SUM, world);
    return sum / comm->nprocs;
  };
  double part[RunClock::PARTS];
  for (int k = 0; k < RunClock::PARTS; k++) part[k] = mean(state.clock().of((RunClock::Part) k));
  const double whole = mean(total);
  auto share = probe_effects(whole, steps);
  double shares = 0.0;
  for (const auto &s : share) shares += std::max(s.second, 0.0);
  if (shares > 1.0) share.clear();    // other load on the machine
  auto bytes = bytes_by_effect();

  std::string text;
  double named = 0.0;
  const double per_step = 1e9 / ((double) atom->natoms * steps);
  auto line = [&](const std::string &name, double seconds, double memory, const char *note = "") {
    const double per_particle = mean(memory) * comm->nprocs / atom->natoms;
    std::string row = fmt::format("  {:<26} {:>10.4g} {:>7.1f} {:>12.2f}", name, seconds, 100.0 * seconds / whole,
                                  seconds * per_step);
    row += memory >= 0.0 ? fmt::format(" {:>10.0f}", per_particle) : fmt::format(" {:>10}", "-");
    text += row + (*note ? std::string("  ") + note : std::string()) + "\n";
    named += seconds;
  };

  const double loops = part[RunClock::PREDICT] + part[RunClock::RATES] + part[RunClock::UPDATE];
  double effects_sum = 0.0;
  for (const auto &s : share) effects_sum += std::max(s.second, 0.0) * loops;    // below 0: lost in the noise
  line("mechanics", loops + part[RunClock::DRIFT] - effects_sum, bytes[0],
       share.empty() ? "and all effects in its loops: too short a run to tell them apart, or too busy a machine" : "");
  for (const unsigned bit : effects_by_name()) {
    if (!state.has(bit)) continue;
    double seconds = 0.0;
    const auto s = share.find(bit);
    if (s != share.end()) seconds += std::max(s->second, 0.0) * loops;
    if (bit == TM_FX_CORRECTION) seconds += part[RunClock::MOMENTS];
    if (bit == TM_FX_HOURGLASS) seconds += part[RunClock::HOURGLASS];
    if (bit == TM_FX_FRACTURE) seconds += part[RunClock::FRACTURE];
    if (bit == TM_FX_CONDUCTION) seconds += part[RunClock::THERMAL];
    if (bit == TM_FX_BODIES) seconds += part[RunClock::BODIES];
    line(effect_name(bit), seconds, bytes[bit], s != share.end() && s->second < 0.0 ? "less than the noise" : "");
  }
  double lists = part[RunClock::ROWS];    // and what goes with them
  for (const auto &f : modify->get_fix_list()) {
    const double seconds = f == &fix ? 0.0 : mean(state.clock().of(f));
    if (utils::strmatch(f->style, "^adapt/neigh")) lists += seconds;
    if (seconds > 0.0) line(fmt::format("fix {} {}", f->id, f->style), seconds, f->memory_usage());
  }
  if (meter) line("audits", mean(state.clock().of((const StepAudit *) meter)), meter->pair_force().bytes());
  line("neighbor rows", part[RunClock::ROWS], scene.rows().bytes());
  line("neighbor lists of LAMMPS", mean(timer->get_wall(Timer::NEIGH)), -1.0);
  line("communication", part[RunClock::COMMUNICATION] + mean(timer->get_wall(Timer::COMM)), -1.0);
  line("output and all else", whole - named, -1.0);
  line("all", whole, -1.0);
  const std::string active = state.active().in_words();
  const std::string audits = meter ? meter->report(part[RunClock::RATES], lists, steps) : "";

  if (comm->me) return;
  utils::logmesg(lmp, "\nsph/tm: {} steps of {} particles\n  {:<26} {:>10} {:>7} {:>12} {:>10}\n{}", steps,
                 atom->natoms, "effect or part", "seconds", "%", "ns/part/step", "bytes/part", text);
  if (!active.empty()) utils::logmesg(lmp, "  active: {}\n", active);
  if (!audits.empty()) utils::logmesg(lmp, "{}", audits);
  utils::logmesg(lmp, "  energy: {}\n",
                 !state.has(TM_FX_LEDGER) ? "not summed up, and not checked; 'energy yes' of fix sph/tm does"
                 : energy.says()          ? energy.in_words()
                                          : "no work went in");
  if (!fracture.empty()) utils::logmesg(lmp, "  numerical fracture: {}\n", fracture);
  if (!failed.empty()) utils::logmesg(lmp, "  failed by damage: {}\n", failed);
  if (state.clock().samples())
    utils::logmesg(lmp,
                   "  The parts were timed on the device, in some of the steps; what the host does meanwhile is not "
                   "among them.\n");
}

// wall time of the run so far, mean over the ranks. Rows: all, rates, prediction and update, neighbor rows;
// columns: seconds, ns per particle and step
double RunTable::value(int row, int column)
{
  using C = RunClock;
  const bigint steps = this->steps();
  if (!timing || steps <= 0) return 0.0;
  double mine = 0.0, sum;
  state.clock().settle();
  if (row == 0) mine = state.clock().total();
  if (row == 1) mine = state.clock().of(C::RATES) + state.clock().of(C::MOMENTS) + state.clock().of(C::HOURGLASS);
  if (row == 2) mine = state.clock().of(C::PREDICT) + state.clock().of(C::UPDATE) + state.clock().of(C::DRIFT);
  if (row == 3) mine = state.clock().of(C::ROWS);
  MPI_Allreduce(&mine, &sum, 1, MPI_DOUBLE, MPI_SUM, world);
  return sum / comm->nprocs * (column ? 1e9 / ((double) atom->natoms * steps) : 1.0);
}

}    // namespace SPHTM_NS
