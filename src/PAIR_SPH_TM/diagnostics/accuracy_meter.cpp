#include "accuracy_meter.h"

#include "all_ranks.h"
#include "scene.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

namespace {
constexpr double XSPH_DEFAULT = 0.5;                              // Monaghan 1989
constexpr double VISCOSITY_DEFAULT = 1.0, ARTSTRESS_EPS = 0.3;    // Fraser 2014

// the same number of a particle on every rank, another in another step
uint64_t draw(uint64_t tag, uint64_t step)
{
  uint64_t z = tag * 0x9e3779b97f4a7c15u + step * 0xd1342543de82ef95u + 1;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}
}    // namespace

AccuracyMeter::AccuracyMeter(LAMMPS *lmp, ParticleState &s, const Scene &sc, int every_, int sample_) :
    Pointers(lmp), state(s), scene(sc), every(every_), sample(sample_), force(s.loops()), surroundings(lmp, s, sc)
{
}

void AccuracyMeter::init()
{
  if (sizeof(tagint) != sizeof(int))
    error->all(FLERR, "Fix sph/tm audit: rows sort by tags of 32 bits; build LAMMPS with SMALLBIG");
}

void AccuracyMeter::restart()
{
  std::fill(last, last + CAUSES, 0.0);
  std::fill(largest, largest + CAUSES, 0.0);
  std::fill(measured, measured + CAUSES, false);
  std::fill(size, size + QUANTITIES, 0.0);
  std::fill(&difference[0][0], &difference[0][0] + CAUSES * QUANTITIES, 0.0);
  times = {};
  surroundings.moments = 0.0;
  audits = 0;
}

// effects that are off and that the state of this scene is enough for
unsigned AccuracyMeter::missing() const
{
  const Model &model = state.model();
  bool solid = false;
  for (int t = 1; t <= atom->ntypes; t++)
    solid = solid || (model.materials()[t].body == TM_BODY_SOLID && model.materials()[t].strength != TM_STRENGTH_NONE);
  unsigned can = unsigned(TM_FX_VISCOSITY) | TM_FX_XSPH;
  if (solid && !state.has(TM_FX_HOURGLASS)) can |= TM_FX_ARTSTRESS;    // the one or the other
  if (!model.settings_in_use().form_f14) can |= TM_FX_CORRECTION;
  // where material flows they fade with strain
  if (state.has(TM_FX_ONE_PASS) && !state.has(TM_FX_PLASTICITY)) can |= TM_FX_FACES;
  if (state.has(TM_FX_HEAT) && model.largest_conductivity() > 0.0) can |= TM_FX_CONDUCTION;
  return can & TM_FX_PRESENT & ~state.effects();
}

// owned particles of the sample: of all solid ones those with the smallest numbers drawn
std::vector<int> AccuracyMeter::choose() const
{
  const tm_material *material = state.model().materials();
  bigint mine = 0, all;
  for (int i = 0; i < atom->nlocal; i++) mine += material[atom->type[i]].body == TM_BODY_SOLID;
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  const size_t wanted = (size_t) std::min((bigint) sample, all);
  for (double more = sample + 6.0 * sqrt(sample) + 16.0;; more *= 2.0) {
    const bool everybody = more >= (double) all;
    const uint64_t limit = everybody ? ~(uint64_t) 0 : (uint64_t) (more / all * 18446744073709549568.0);
    std::vector<std::pair<uint64_t, int>> candidate;
    std::vector<uint64_t> number;
    for (int i = 0; i < atom->nlocal; i++) {
      const uint64_t k = draw(atom->tag[i], update->ntimestep);
      if (k > limit || material[atom->type[i]].body != TM_BODY_SOLID) continue;
      candidate.push_back({k, i});
      number.push_back(k);
    }
    std::vector<uint64_t> numbers = of_all_ranks(number, world);
    if (numbers.size() < wanted && !everybody) continue;
    std::sort(numbers.begin(), numbers.end());
    std::sort(candidate.begin(), candidate.end());
    std::vector<int> chosen;
    for (const auto &c : candidate)
      if (wanted && c.first <= numbers[wanted - 1]) chosen.push_back(c.second);
    return chosen;
  }
}

/* ---------------------------------------------------------------------- rates */

AccuracyMeter::Rates AccuracyMeter::rates(AuditPatch &p, const tm_records &rec, unsigned effects, const double *K,
                                          const double *turn) const
{
  const int n = p.centers;
  const size_t room = n + 1, all = p.member.size() + 1;
  tm_rates_args a = scene.results().rate_args();
  a.rows = p.rows();
  a.rec = rec;
  a.effects = effects;
  a.conductance = nullptr;
  a.which = nullptr;
  if (!state.has(TM_FX_VISCOSITY)) {
    a.visc_alpha = VISCOSITY_DEFAULT;
    a.visc_beta = VISCOSITY_DEFAULT;
  }
  if (!state.has(TM_FX_XSPH)) a.xsph = XSPH_DEFAULT;
  Rates r;
  r.force.resize(3 * room);
  r.gradient.resize(9 * room);
  r.heat.resize(effects & TM_FX_CONDUCTION ? room : 0);
  r.xsph.resize(effects & TM_FX_XSPH ? 3 * room : 0);
  std::vector<double> surface(effects & TM_FX_SURFACE ? 3 * room : 0);
  std::vector<float> main, more, correction, size, stab;
  if (effects & TM_FX_MIXED) {
    main.resize(TM_REC * all);
    more.resize(effects & (TM_FX_ARTSTRESS | TM_FX_CONDUCTION) ? TM_MORE * all : 0);
    correction.resize(rec.correction ? TM_REC_CORRECTION * all : 0);
    stab.resize(effects & TM_FX_ONE_PASS ? TM_REC_STAB * all : 0);
    size.resize(effects & TM_FX_SMOOTHING ? TM_REC_SIZE * all : 0);
    auto part = [](std::vector<float> &v) { return v.empty() ? nullptr : v.data(); };
    a.single.main = part(main);
    a.single.more = part(more);
    a.single.correction = part(correction);
    a.single.size = part(size);
    a.single.stab = part(stab);
    PairLoops::of(Backend::host()).round_to_single(Backend::host(), (int) p.member.size(), {rec, a.single, 0}, effects);
  }
  a.force = r.force.data();
  a.force_begins = 1;
  a.gradient = r.gradient.data();
  a.heat = r.heat.data();
  a.correction = const_cast<double *>(K);
  a.turn = const_cast<double *>(turn);
  a.xsph_v = r.xsph.data();
  a.surface = surface.data();
  a.artificial = a.uneven = nullptr;
  const bool one_pass = (effects & TM_FX_ONE_PASS) != 0, hourglass = !one_pass && (effects & TM_FX_HOURGLASS);
  std::vector<double> hourglass_rate(3 * room), moment(TM_MOMENT_COLUMNS * room), face_next(TM_FACE_COLUMNS * room);
  a.moment = moment.data();
  a.face_next = face_next.data();
  a.hourglass_rate = hourglass_rate.data();
  r.seconds = 1e300;
  for (int turn = 0; turn < 2; turn++) {    // the second finds its data in the cache
    const double began = RunClock::processor_time();
    PairLoops::of(Backend::host()).rates(Backend::host(), n, a, effects);
    if (hourglass) PairLoops::of(Backend::host()).hourglass(Backend::host(), n, a, effects);
    r.seconds = std::min(r.seconds, RunClock::processor_time() - began);
  }
  return r;
}

// records whose stress is without the share of a balanced artificial stress, see tm_balance.h
void AccuracyMeter::undo_balance(const AuditPatch &p, const tm_records &rec, std::vector<double> &main) const
{
  Model &model = state.model();
  const double share = tm_share_of(model.loop_tables().share.host_read(), nullptr, model.settings_in_use().ratio);
  main = p.main;
  for (size_t k = 0; k < p.member.size(); k++) {
    double *r = main.data() + k * TM_REC;
    const double scale = share * (state.has(TM_FX_FORM_F14) ? r[TM_REC_RHO] * r[TM_REC_RHO] : 1.0);
    for (int c = 0; c < TM_REC_STRESS; c++) r[TM_REC_P + c] += scale * rec.stress[k * TM_REC_STRESS + c];
  }
}

void AccuracyMeter::audit(const InUse &in_use)
{
  state.atoms().to_host();
  Model &model = state.model();
  const unsigned used = state.effects(), absent = missing(), full = (used | absent) & ~unsigned(TM_FX_MIXED);
  AuditSearch search(lmp, state, scene.results().host_records());
  AuditPatch p = search.around(choose(), search.farthest);
  const std::vector<AuditSurroundings::Around> around = surroundings.of_members(search, p, full);
  const int members = (int) p.member.size(), n = p.centers;

  // records of what is not in use, and of sizes as they should be
  const double alpha = absent & TM_FX_VISCOSITY ? VISCOSITY_DEFAULT : model.settings_in_use().visc_alpha;
  if ((absent & TM_FX_VISCOSITY) && (used & TM_FX_ONE_PASS) && !(used & TM_FX_FACES))
    for (int k = 0; k < members; k++) p.stab[k * TM_REC_STAB + TM_STAB_C] = alpha * p.main[k * TM_REC + TM_REC_C];
  tm_records rec = p.records(), sized;
  std::vector<double> K, turn, stress, sizes;
  p.correction.clear();
  for (int k = 0; k < members; k++) {
    const AuditSurroundings::Around &a = around[k];
    if (k < n && !(used & TM_FX_ONE_PASS)) K.insert(K.end(), a.linear.K, a.linear.K + 6);
    else if (k < n)
      K.insert(K.end(), in_use.correction + 6 * (size_t) p.member[k], in_use.correction + 6 * (size_t) p.member[k] + 6);
    if (k < n && (used & TM_FX_FACES))
      turn.insert(turn.end(), in_use.turn + 3 * (size_t) p.member[k], in_use.turn + 3 * (size_t) p.member[k] + 3);
    p.correction.insert(p.correction.end(), a.linear.PK, a.linear.PK + TM_REC_CORRECTION);
    sizes.insert(sizes.end(), a.size, a.size + TM_REC_SIZE);
  }
  rec.correction = used & TM_FX_ONE_PASS ? nullptr : p.correction.data();
  if (absent & TM_FX_ARTSTRESS) {
    stress.resize((size_t) TM_REC_STRESS * members + 1);
    rec.stress = stress.data();
    tm_predict_args a = {};
    a.rec = rec;
    a.art_eps = ARTSTRESS_EPS;
    a.art_component = model.settings_in_use().art_component;
    const double began = RunClock::processor_time();
    tm_predict_artstress(0, members, &a, full);
    if (members) times.tensile += (RunClock::processor_time() - began) / members;
  }
  sized = rec;
  sized.size = sizes.data();

  Rates of[CAUSES];
  const Rates *from[CAUSES] = {};
  bool shown[CAUSES] = {};
  const unsigned exact = used & ~unsigned(TM_FX_MIXED);
  // other corrections than those in use, of second order where faces are off and of linear order where they are on
  AuditSurroundings::Stabilized other;
  if (((used | absent) & TM_FX_FACES) && (used & TM_FX_ONE_PASS))
    other = AuditSurroundings::stabilized(p, around, (absent & TM_FX_FACES) != 0, alpha);
  auto take = [&](int cause, tm_records records, unsigned effects) {
    const bool others = ((effects ^ used) & TM_FX_FACES) != 0;
    if (others) records.stab = other.stab.data();
    of[cause] =
        rates(p, records, effects, others ? other.K.data() : K.data(), others ? other.turn.data() : turn.data());
    from[cause] = &of[cause];
    shown[cause] = true;
    if (n) times.cause[cause] += of[cause].seconds / n;
  };
  take(ROWS, rec, used);
  if (used != exact) take(PRECISION, rec, exact);
  take(SMOOTHING, sized, exact | TM_FX_SMOOTHING);
  for (int k = FIRST_EFFECT; k < CAUSES; k++) {
    const Compared &e = EFFECTS[k - FIRST_EFFECT];
    if (!e.on && (absent & e.effect)) take(k, rec, exact | e.effect);
    if (!e.on || !(used & e.effect)) continue;
    tm_records without = rec;
    std::vector<double> main;
    if (e.effect == TM_FX_ARTSTRESS) {
      undo_balance(p, rec, main);
      without.main = main.data();
    }
    std::vector<double> stab = p.stab;
    if (e.effect == TM_FX_HOURGLASS && (used & TM_FX_ONE_PASS)) {    // of the same pass
      for (size_t r = 0; r < stab.size(); r += TM_REC_STAB) std::fill_n(stab.data() + r + TM_STAB_W, 3, 0.0);
      without.stab = stab.data();
      take(k, without, exact);
    } else take(k, without, exact & ~e.effect);
  }
  take(ALL, sized, full | TM_FX_SMOOTHING);
  if (search.rows) {
    times.rows += search.seconds_of_rows / search.rows;
    times.sorting += search.seconds_of_sorting / atom->nlocal;
  }
  times.moments = surroundings.moments;
  add_differences(p, in_use, from, shown);
}

// each cause by itself, from the rates of a fresh search in double with the effects in use
void AccuracyMeter::add_differences(const AuditPatch &p, const InUse &in_use, const Rates *const of[],
                                    const bool shown[])
{
  const unsigned used = state.effects();
  // sums of squares: of the rates in use, of the best ones, of the differences
  double mine[(CAUSES + 2) * QUANTITIES] = {}, sum[(CAUSES + 2) * QUANTITIES];
  const Rates &base = *of[shown[PRECISION] ? PRECISION : ROWS];
  for (int k = 0; k < p.centers; k++) {
    const int i = p.member[k];
    const double *record = p.main.data() + (size_t) k * TM_REC;
    struct Values {
      double of[QUANTITIES][9];
    };
    auto values = [&](const double *f, const double *g, const double *q, const double *u, int row) {
      Values v = {};
      for (int c = 0; c < 3; c++) {
        v.of[ACCELERATION][c] = f[3 * (size_t) row + c] / record[TM_REC_M];
        v.of[MOTION][c] = record[TM_REC_V + c] + (u ? u[3 * (size_t) row + c] : 0.0);
      }
      std::copy_n(g + 9 * (size_t) row, 9, v.of[GRADIENT]);
      if (q) v.of[HEAT][0] = q[row];
      return v;
    };
    auto computed = [&](const Rates &r) {
      return values(r.force.data(), r.gradient.data(), r.heat.empty() ? nullptr : r.heat.data(),
                    r.xsph.empty() ? nullptr : r.xsph.data(), k);
    };
    auto add = [&](int row, const Values &a, const Values &b) {
      for (int q = 0; q < QUANTITIES; q++)
        for (int c = 0; c < 9; c++) {
          const double d = a.of[q][c] - b.of[q][c];
          mine[row * QUANTITIES + q] += d * d;
        }
    };
    const Values u = values(in_use.force, in_use.gradient, used & TM_FX_CONDUCTION ? in_use.heat : nullptr,
                            used & TM_FX_XSPH ? in_use.xsph : nullptr, i);
    const Values b = computed(base), best = computed(*of[ALL]), fresh = computed(*of[ROWS]);
    add(CAUSES, u, {});
    add(CAUSES + 1, best, {});
    add(ALL, best, u);
    add(ROWS, fresh, u);
    add(PRECISION, b, fresh);
    for (int cause = SMOOTHING; cause < CAUSES; cause++)
      if (shown[cause]) add(cause, computed(*of[cause]), b);
  }
  MPI_Allreduce(mine, sum, (CAUSES + 2) * QUANTITIES, MPI_DOUBLE, MPI_SUM, world);
  for (int cause = 0; cause < CAUSES; cause++) {
    last[cause] = 0.0;
    measured[cause] = measured[cause] || shown[cause];
    for (int q = 0; q < QUANTITIES; q++) {
      const double whole = std::max(sum[CAUSES * QUANTITIES + q], sum[(CAUSES + 1) * QUANTITIES + q]);
      const double part = sum[cause * QUANTITIES + q];
      if (whole > 0.0) last[cause] = std::max(last[cause], sqrt(part / whole));
      difference[cause][q] += part;
    }
    largest[cause] = std::max(largest[cause], last[cause]);
  }
  for (int q = 0; q < QUANTITIES; q++)
    size[q] += std::max(sum[CAUSES * QUANTITIES + q], sum[(CAUSES + 1) * QUANTITIES + q]);
  audits++;
}

/* ---------------------------------------------------------------------- */

// Times saved: what the loops of the samples take more with the cause away, as a share of what the run's take.
// Rows that are kept: a search and a rate pass of every particle in every step, less what the run took for both.
std::string AccuracyMeter::report(double rates, double lists, bigint steps)
{
  if (audits == 0) return "";
  Times all;
  MPI_Allreduce(&times, &all, sizeof(Times) / sizeof(double), MPI_DOUBLE, MPI_SUM, world);
  const double base = all.cause[measured[PRECISION] ? PRECISION : ROWS];
  const bool keeps = scene.rows().has_tl();
  std::string text = fmt::format(
      "\n  audits: {} of {} particles; root mean square of the difference to a fresh search in double with all "
      "effects,\n  and of what artificial terms add that are on\n  {:<26} {:>10} {:>10} {:>10} {:>10} {:>10} {:>10}\n",
      audits, sample, "cause", "accel.", "vel.grad.", "heat", "motion", "largest", "saves s");
  auto line = [&](int cause, const std::string &name, bool timed, double saved) {
    text += fmt::format("  {:<26}", name);
    for (int q = 0; q < QUANTITIES; q++)
      text += fmt::format(" {:>10.3g}", size[q] > 0.0 ? sqrt(difference[cause][q] / size[q]) : 0.0);
    text += fmt::format(" {:>10.3g}", largest[cause]);
    text += timed ? fmt::format(" {:>10.3g}\n", saved) : fmt::format(" {:>10}\n", "-");
  };
  auto more = [&](double time) { return base > 0.0 ? (time / base - 1.0) * rates : 0.0; };
  const double ranks = comm->nprocs, per_rank = atom->natoms / ranks * steps / (audits * ranks);
  const bool host = state.loops().shared();
  line(ROWS, "stale rows", keeps && host, (all.cause[ROWS] + all.rows + all.sorting) * per_rank - rates - lists);
  if (measured[PRECISION]) line(PRECISION, "single precision", true, (base / all.cause[ROWS] - 1.0) * rates);
  line(SMOOTHING, "smoothing length", !state.has(TM_FX_SMOOTHING), more(all.cause[SMOOTHING]));
  for (int k = FIRST_EFFECT; k < CAUSES; k++) {
    if (!measured[k]) continue;
    const Compared &e = EFFECTS[k - FIRST_EFFECT];
    double time = all.cause[k];
    if (e.effect == TM_FX_CORRECTION) time += all.moments;
    if (!e.on && e.effect == TM_FX_ARTSTRESS) time += all.tensile;
    line(k, e.name, true, more(time));
  }
  line(ALL, "all of them", false, 0.0);
  return text;
}

}    // namespace SPHTM_NS
