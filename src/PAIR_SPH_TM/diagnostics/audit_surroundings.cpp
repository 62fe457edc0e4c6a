#include "audit_surroundings.h"

#include "all_ranks.h"
#include "scene.h"

#include "atom.h"
#include "domain.h"
#include "neighbor.h"

#include <algorithm>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

namespace {
constexpr int PSI_TURNS = 5;    // of the rule of asph psi, to the length it wants

// with one pass those in use are there, and others are asked for where faces are on or could be
bool needs_corrections(unsigned effects)
{
  return (effects & TM_FX_CORRECTION) && (!(effects & TM_FX_ONE_PASS) || (effects & TM_FX_FACES));
}
}    // namespace

AuditSurroundings::AuditSurroundings(LAMMPS *lmp, ParticleState &s, const Scene &sc) :
    Pointers(lmp), state(s), scene(sc)
{
}

// Corrections for the lengths in use. With one pass both of a set-up, which takes those of the present positions: of
// linear order and with the normals of faces.
void AuditSurroundings::corrections(AuditPatch &p, tm_rates_args a, unsigned effects, std::vector<Around> &out)
{
  const int n = p.centers, one_pass = (effects & TM_FX_ONE_PASS) != 0;
  std::vector<double> K(6 * (size_t) n + 1), turn(3 * (size_t) n + 1), PK((size_t) TM_REC_CORRECTION * n + 1);
  a.correction = K.data();
  a.turn = turn.data();
  if (!one_pass) a.rec.correction = PK.data();
  for (int faces = 0; faces <= one_pass; faces++) {
    a.rec.faces = faces;
    const double began = RunClock::processor_time();
    PairLoops::of(Backend::host()).correction(Backend::host(), n, a, effects);
    if (n && !faces) moments += (RunClock::processor_time() - began) / n;
    for (int k = 0; k < n; k++) {
      Correction &c = faces ? out[k].second : out[k].linear;
      const double *record = one_pass ? a.rec.stab + (size_t) k * TM_REC_STAB
                                      : PK.data() + (size_t) k * TM_REC_CORRECTION;
      std::copy_n(K.data() + 6 * (size_t) k, 6, c.K);
      std::copy_n(record + (one_pass ? (int) TM_STAB_PK : 0), (int) TM_REC_CORRECTION, c.PK);
      if (!faces) continue;
      std::copy_n(turn.data() + 3 * (size_t) k, 3, c.turn);
      std::copy_n(record + TM_STAB_FACE, 3, c.normal);
    }
  }
}

// corrections, and smoothing lengths by the rule
std::vector<AuditSurroundings::Around> AuditSurroundings::of_centers(AuditPatch &p, unsigned effects,
                                                                     const SmoothingRule &rule)
{
  Model &model = state.model();
  const int n = p.centers, dim3 = domain->dimension == 3;
  const tm_records rec = p.records();
  tm_rates_args a = scene.results().rate_args();
  a.rows = p.rows();
  a.rec = rec;
  a.which = nullptr;
  a.uneven = nullptr;
  a.effects = effects;
  std::vector<Around> out(n);
  if (needs_corrections(effects)) corrections(p, a, effects, out);

  std::vector<double> own((size_t) TM_S_COLUMNS * n + 1), rho(n + 1), mass(n + 1);
  std::vector<int> type(n + 1);
  const double *sizes = state.has(TM_FX_SMOOTHING) ? state.field(TM_F_SIZE) : nullptr, *density = state.field(TM_F_RHO);
  for (int k = 0; k < n; k++) {
    const int i = p.member[k];
    type[k] = atom->type[i];
    mass[k] = p.main[(size_t) k * TM_REC + TM_REC_M];
    rho[k] = density[i];
    double *s = own.data() + (size_t) k * TM_S_COLUMNS;
    if (sizes) std::copy_n(sizes + (size_t) i * TM_S_COLUMNS, (int) TM_S_COLUMNS, s);
    else tm_size_initial(s, mass[k], model.materials()[type[k]].rho0, model.settings_in_use().ratio, dim3);
  }
  tm_smoothing_args s = {};
  s.state.field[TM_F_SIZE] = own.data();
  s.state.field[TM_F_RHO] = rho.data();
  s.state.material = model.materials();
  s.state.type = type.data();
  s.rec = rec;
  s.rows = a.rows;
  s.table = rule.table;
  s.least = rule.least;
  s.most = rule.most;
  const double most = (model.covered_h() > 0.0 ? model.covered_h() : model.settings_in_use().h) +
                      neighbor->skin / tm_kernel_support(model.settings_in_use().kernel);
  for (int turn = 0; turn < (rule.table ? PSI_TURNS : 1); turn++) {
    SearchLoops::of(Backend::host()).smoothing(Backend::host(), n, s, effects);
    for (int k = 0; k < n; k++) {
      double &h = own[(size_t) k * TM_S_COLUMNS + TM_S_H];
      h = std::min(h, most);
    }
  }

  for (int k = 0; k < n; k++) {
    out[k].tag = atom->tag[p.member[k]];
    tm_size_record(own.data() + (size_t) k * TM_S_COLUMNS, mass[k] / p.main[(size_t) k * TM_REC + TM_REC_RHO],
                   gradient_factors.data(), tm_fx_kernel(effects), dim3, out[k].size);
  }
  return out;
}

// of all members: those of other ranks and images of periodic boxes are asked for by tag
std::vector<AuditSurroundings::Around> AuditSurroundings::of_members(AuditSearch &search, const AuditPatch &p,
                                                                     unsigned effects)
{
  const SmoothingRule rule = scene.adaptation().smoothing ? *scene.adaptation().smoothing : SmoothingRule();
  if (gradient_factors.empty()) {
    gradient_factors.resize(TM_GRADIENT_ENTRIES);
    tm_gradient_table(tm_fx_kernel(effects), domain->dimension, gradient_factors.data());
  }

  std::vector<int> own, asked;
  for (const int i : p.member)
    if (i < atom->nlocal) own.push_back(i);
    else asked.push_back(atom->tag[i]);
  std::vector<int> all = of_all_ranks(asked, world);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  const size_t mine = own.size();
  for (int i = 0; i < atom->nlocal && !all.empty(); i++)
    if (std::binary_search(all.begin(), all.end(), (int) atom->tag[i])) own.push_back(i);

  AuditPatch wider;
  if (needs_corrections(effects) || rule.table)
    wider = search.around(own, rule.table ? search.farthest : search.radius);
  else wider = search.alone(own);
  std::vector<Around> known = of_centers(wider, effects, rule);
  std::vector<Around> given = of_all_ranks(std::vector<Around>(known.begin() + mine, known.end()), world);
  const auto before = [](const Around &a, const Around &b) { return a.tag < b.tag; };
  std::sort(given.begin(), given.end(), before);
  std::vector<Around> out;
  size_t next = 0;
  for (const int i : p.member) {
    Around key = {};
    key.tag = atom->tag[i];
    out.push_back(i < atom->nlocal ? known[next++] : *std::lower_bound(given.begin(), given.end(), key, before));
  }
  return out;
}

AuditSurroundings::Stabilized AuditSurroundings::stabilized(const AuditPatch &p, const std::vector<Around> &around,
                                                            bool faces, double alpha)
{
  Stabilized s;
  s.stab = p.stab;
  for (size_t k = 0; k < p.member.size(); k++) {
    const Correction &c = faces ? around[k].second : around[k].linear;
    double *record = s.stab.data() + k * TM_REC_STAB;
    std::copy_n(c.PK, (int) TM_REC_CORRECTION, record + TM_STAB_PK);
    if (faces) std::copy_n(c.normal, 3, record + TM_STAB_FACE);
    else record[TM_STAB_C] = alpha * p.main[k * TM_REC + TM_REC_C];
    if (k >= (size_t) p.centers) continue;
    s.K.insert(s.K.end(), c.K, c.K + 6);
    s.turn.insert(s.turn.end(), c.turn, c.turn + 3);
  }
  return s;
}

}    // namespace SPHTM_NS
