/* SPH-TM: compute sph/tm/atom. See doc/compute_sph_tm_atom.rst. */
#include "compute_sph_tm_atom.h"

#include "fix_sph_tm.h"
#include "pair_sph_tm.h"

#include "atom.h"
#include "error.h"
#include "memory.h"
#include "modify.h"
#include "update.h"

#include <cmath>
#include <cstring>
#include <string>

using namespace LAMMPS_NS;

namespace {

struct Particle {
  FixSPHTM *fix;
  PairSPHTM *pair;
  const tm_material *m;
  int i;
  const tm_real *main, *surface, *neighbors;    // of all particles, or nullptr
  double state(int id, int column, double otherwise) const
  {
    const double *d = fix->field(id);
    return d ? d[(size_t) i * tm_field_table[id].columns + column] : otherwise;
  }
  double rho() const { return state(TM_F_RHO, 0, 0.0); }
  bool failed() const { return state(TM_F_DAMAGE, 1, 0.0) > 0.5; }
  double pressure() const
  {
    if (m->body != TM_BODY_SOLID) return 0.0;
    if (fix->has(TM_FX_PLANE_STRESS)) return state(TM_F_STRESS, 2, 0.0);
    return tm_damage_pressure(tm_eos_pressure(m, rho(), state(TM_F_ENERGY, 0, 0.0)), failed());
  }
  tm_sym3 deviator() const { return tm_sym_load(fix->field(TM_F_STRESS) + 6 * (size_t) i); }
  double stress() const { return 1.0 / pair->units().stress; }    // to the pressure unit
};

double sigma(const Particle &p, int k)
{
  const double *s = p.fix->field(TM_F_STRESS) + 6 * (size_t) p.i;
  return p.stress() * (s[k] - (k < 3 ? p.pressure() : 0.0));
}

struct Attribute {
  const char *name;
  double (*value)(const Particle &);
};

const Attribute ATTRIBUTES[] = {
    {"density", [](const Particle &p) { return p.rho() / p.pair->units().density; }},
    {"temperature", [](const Particle &p) { return p.fix->temperature(p.i); }},
    {"pstrain", [](const Particle &p) { return p.state(TM_F_PSTRAIN, 0, 0.0); }},
    {"pstrain/rate", [](const Particle &p) { return p.state(TM_F_PSTRAIN, 1, 0.0); }},
    {"flowstress", [](const Particle &p) { return p.stress() * p.state(TM_F_PSTRAIN, 2, 0.0); }},
    {"vonmises", [](const Particle &p) { return p.stress() * tm_sym_mises(p.deviator()); }},
    {"pressure", [](const Particle &p) { return p.stress() * p.pressure(); }},
    {"stress/xx", [](const Particle &p) { return sigma(p, 0); }},
    {"stress/yy", [](const Particle &p) { return sigma(p, 1); }},
    {"stress/zz", [](const Particle &p) { return sigma(p, 2); }},
    {"stress/xy", [](const Particle &p) { return sigma(p, 3); }},
    {"stress/xz", [](const Particle &p) { return sigma(p, 4); }},
    {"stress/yz", [](const Particle &p) { return sigma(p, 5); }},
    {"damage", [](const Particle &p) { return p.state(TM_F_DAMAGE, 0, 0.0); }},
    {"failed", [](const Particle &p) { return p.failed() ? 1.0 : 0.0; }},
    {"energy", [](const Particle &p) { return p.state(TM_F_ENERGY, 0, 0.0) / p.pair->units().energy; }},
    {"thickness", [](const Particle &p) { return p.state(TM_F_THICKNESS, 0, 1.0); }},
    {"soundspeed",
     [](const Particle &p) {
       return p.m->body == TM_BODY_SOLID
           ? tm_eos_sound_speed(p.m, p.rho(), p.state(TM_F_ENERGY, 0, 0.0)) : 0.0;
     }},
    {"h", [](const Particle &p) { return p.state(TM_F_SIZE, TM_S_H, p.pair->settings_in_use().h); }},
    {"neighbors", [](const Particle &p) { return p.neighbors ? p.neighbors[p.i] : 0.0; }},
    {"surface/area",
     [](const Particle &p) {
       if (!p.surface) return 0.0;
       const double *g = p.surface + 3 * (size_t) p.i;
       const double *r = p.main + (size_t) p.i * TM_REC;
       return tm_surface_area(&p.pair->surface_measure(), tm_vec(g[0], g[1], g[2]), r[TM_REC_M] / r[TM_REC_RHO]);
     }},
};
constexpr int N_ATTRIBUTES = sizeof(ATTRIBUTES) / sizeof(ATTRIBUTES[0]);

}    // namespace

ComputeSPHTMAtom::ComputeSPHTMAtom(LAMMPS *lmp, int narg, char **arg) : Compute(lmp, narg, arg)
{
  std::string known;
  for (const auto &a : ATTRIBUTES) known += std::string(" ") + a.name;
  if (narg < 4) error->all(FLERR, "Compute sph/tm/atom needs at least one attribute:{}", known);
  for (int iarg = 3; iarg < narg; iarg++) {
    int found = -1;
    for (int k = 0; k < N_ATTRIBUTES; k++)
      if (strcmp(arg[iarg], ATTRIBUTES[k].name) == 0) found = k;
    if (found < 0) error->all(FLERR, "Unknown compute sph/tm/atom attribute {}: known are{}", arg[iarg], known);
    wanted.push_back(found);
  }
  peratom_flag = 1;
  size_peratom_cols = wanted.size() == 1 ? 0 : (int) wanted.size();
}

ComputeSPHTMAtom::~ComputeSPHTMAtom()
{
  memory->destroy(vector_atom);
  memory->destroy(array_atom);
}

void ComputeSPHTMAtom::init()
{
  find_fix();
  for (int k : wanted)
    if (strcmp(ATTRIBUTES[k].name, "surface/area") == 0)
      fix->need(TM_FX_SURFACE, fmt::format("compute {} shows surface/area", id));
}

void ComputeSPHTMAtom::find_fix()
{
  auto fixes = modify->get_fix_by_style("^sph/tm$");
  if (fixes.empty()) error->all(FLERR, "Compute sph/tm/atom needs a fix sph/tm; write 'fix body all sph/tm'");
  fix = dynamic_cast<FixSPHTM *>(fixes[0]);
}

void ComputeSPHTMAtom::compute_peratom()
{
  invoked_peratom = update->ntimestep;
  find_fix();    // it may have gone since the last run
  if (!fix->pair()) error->all(FLERR, "Compute sph/tm/atom {}: fix sph/tm has no state before a run; use 'run 0'", id);
  const int columns = (int) wanted.size();
  if (atom->nmax > nmax) {
    nmax = atom->nmax;
    memory->destroy(vector_atom);
    memory->destroy(array_atom);
    if (size_peratom_cols == 0) memory->create(vector_atom, nmax, "sph/tm/atom:vector");
    else memory->create(array_atom, nmax, columns, "sph/tm/atom:array");
  }
  Particle p = {fix, fix->pair(), nullptr, 0, nullptr, nullptr, nullptr};
  for (int k : wanted) {
    const std::string name = ATTRIBUTES[k].name;
    if (name == "neighbors") p.neighbors = p.pair->host_neighbors();
    if (name != "surface/area" || !p.pair->has_surface(atom->nlocal)) continue;
    p.main = p.pair->host_records().main;
    p.surface = p.pair->host_surface();
  }
  for (int i = 0; i < atom->nlocal; i++) {
    p.i = i;
    p.m = p.pair->materials() + atom->type[i];
    const bool in = atom->mask[i] & groupbit;
    for (int k = 0; k < columns; k++) {
      const double value = in ? ATTRIBUTES[wanted[k]].value(p) : 0.0;
      if (size_peratom_cols == 0) vector_atom[i] = value;
      else array_atom[i][k] = value;
    }
  }
}

double ComputeSPHTMAtom::memory_usage() { return (double) nmax * wanted.size() * sizeof(double); }
