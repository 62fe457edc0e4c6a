/* SPH-TM: compute sph/tm/atom. See doc/compute_sph_tm_atom.rst. */
#include "compute_sph_tm_atom.h"

#include "fix_sph_tm.h"
#include "pair_sph_tm.h"

#include "atom.h"
#include "error.h"
#include "memory.h"
#include "modify.h"
#include "update.h"

#include <algorithm>
#include <cstring>
#include <string>

using namespace LAMMPS_NS;

namespace {

#define TM_OUTPUT_NAME(id, name) name,
const char *const ATTRIBUTES[] = {TM_OUTPUT_TABLE(TM_OUTPUT_NAME)};
#undef TM_OUTPUT_NAME

}    // namespace

bool ComputeSPHTMAtom::knows(const std::string &attribute)
{
  return std::find(std::begin(ATTRIBUTES), std::end(ATTRIBUTES), attribute) != std::end(ATTRIBUTES);
}

ComputeSPHTMAtom::ComputeSPHTMAtom(LAMMPS *lmp, int narg, char **arg) : Compute(lmp, narg, arg)
{
  std::string known;
  for (const char *name : ATTRIBUTES) known += std::string(" ") + name;
  if (narg < 4) error->all(FLERR, "Compute sph/tm/atom needs at least one attribute:{}", known);
  for (int iarg = 3; iarg < narg; iarg++) {
    int found = -1;
    for (int k = 0; k < TM_OUT_COUNT; k++)
      if (strcmp(arg[iarg], ATTRIBUTES[k]) == 0) found = k;
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
  if (wants(TM_OUT_AREA)) fix->need(TM_FX_SURFACE, fmt::format("compute {} shows surface/area", id));
}

void ComputeSPHTMAtom::find_fix()
{
  fix = FixSPHTM::of(lmp, "Compute sph/tm/atom");
}

bool ComputeSPHTMAtom::wants(int attribute) const
{
  return std::find(wanted.begin(), wanted.end(), attribute) != wanted.end();
}

// where the loops run
tm_output_args ComputeSPHTMAtom::output_args()
{
  PairSPHTM *pair = fix->pair();
  tm_output_args a = {};
  a.neighbors = wants(TM_OUT_NEIGHBORS) ? pair->loop_neighbors() : nullptr;
  a.state = fix->state();
  a.effects = fix->effects();
  a.group = groupbit;
  if (wants(TM_OUT_AREA) && pair->has_surface(atom->nlocal)) {
    a.main = pair->rate_args().rec.main;
    a.surface = pair->rate_args().surface;
  }
  if (wants(TM_OUT_ADAPTNODE) || wants(TM_OUT_SEARCHES)) {
    int dim;
    const auto lists = modify->get_fix_by_style("^adapt/neigh");
    if (lists.empty() || !lists[0]->extract("sph/tm rows", dim))
      error->all(FLERR, "Compute sph/tm/atom adaptnode, searches: needs fix adapt/neigh with threshold");
    a.lists = (const tm_real *) lists[0]->extract("memory of lists", dim);
  }
  a.measure = pair->surface_measure();
  a.temperature = fix->start_temperature();
  a.h = pair->settings_in_use().h;
  a.stress = pair->units().stress;
  a.density = pair->units().density;
  a.energy = pair->units().energy;
  a.columns = (int) wanted.size();
  return a;
}

void ComputeSPHTMAtom::run_output(double *value)
{
  tm_output_args a = output_args();
  a.wanted = wanted.data();
  a.value = value;
  fix->loops().blocks(atom->nlocal, [&](int begin, int end) {
    for (int i = begin; i < end; i++) tm_output(i, &a);
  });
}

void ComputeSPHTMAtom::compute_peratom()
{
  invoked_peratom = update->ntimestep;
  find_fix();    // it may have gone since the last run
  FixSPHTM::current(lmp, fix, fmt::format("Compute sph/tm/atom {}", id));
  if (atom->nmax > nmax) {
    nmax = atom->nmax;
    memory->destroy(vector_atom);
    memory->destroy(array_atom);
    if (size_peratom_cols == 0) memory->create(vector_atom, nmax, "sph/tm/atom:vector");
    else memory->create(array_atom, nmax, size_peratom_cols, "sph/tm/atom:array");
  }
  if (!atom->nlocal) return;
  double *value = size_peratom_cols == 0 ? vector_atom : array_atom[0];
  run_output(value);
  if (wants(TM_OUT_LEVEL)) put_level(value);
}

// fix adapt/neigh, where there is one, keeps the levels on the host
void ComputeSPHTMAtom::put_level(double *value)
{
  int dim;
  const auto fixes = modify->get_fix_by_style("^adapt/neigh$");
  const auto *level = fixes.empty() ? nullptr : (const double *) fixes[0]->extract("level", dim);
  for (size_t k = 0; level && k < wanted.size(); k++)
    for (int i = 0; wanted[k] == TM_OUT_LEVEL && i < atom->nlocal; i++)
      if (atom->mask[i] & groupbit) value[i * wanted.size() + k] = level[i];
}

double ComputeSPHTMAtom::memory_usage() { return (double) nmax * wanted.size() * sizeof(double); }
