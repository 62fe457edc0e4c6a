/* SPH-TM: compute sph/tm/atom. See doc/compute_sph_tm_atom.rst. */
#include "compute_sph_tm_atom.h"

#include "atom.h"
#include "error.h"
#include "memory.h"
#include "update.h"

#include <algorithm>
#include <cstring>
#include <string>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

namespace {

#define TM_OUTPUT_NAME(id, name) name,
const char *const ATTRIBUTES[] = {TM_OUTPUT_TABLE(TM_OUTPUT_NAME)};
#undef TM_OUTPUT_NAME

}    // namespace

ComputeSPHTMAtom::ComputeSPHTMAtom(LAMMPS *lmp, int narg, char **arg) : Compute(lmp, narg, arg), scene(Scene::of(lmp))
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
  state = &scene->state("Compute sph/tm/atom");
  if (wants(TM_OUT_AREA)) state->need(TM_FX_SURFACE, fmt::format("compute {} shows surface/area", id));
}

const char *ComputeSPHTMAtom::attribute(int column) const { return ATTRIBUTES[wanted[column]]; }

bool ComputeSPHTMAtom::wants(int attribute) const
{
  return std::find(wanted.begin(), wanted.end(), attribute) != wanted.end();
}

// where the loops run
tm_output_args ComputeSPHTMAtom::output_args()
{
  StepResults &results = scene->results();
  const Model &model = scene->model();
  tm_output_args a = {};
  a.neighbors = wants(TM_OUT_NEIGHBORS) ? results.loop_neighbors() : nullptr;
  a.state = state->arrays();
  a.effects = state->effects();
  a.group = groupbit;
  if (wants(TM_OUT_AREA) && results.has_surface(atom->nlocal)) {
    a.main = results.rate_args().rec.main;
    a.surface = results.rate_args().surface;
  }
  if (wants(TM_OUT_ADAPTNODE) || wants(TM_OUT_SEARCHES)) {
    const Scene::Adaptation &lists = scene->adaptation();
    if (!lists.rows) error->all(FLERR, "Compute sph/tm/atom adaptnode, searches: needs fix adapt/neigh with threshold");
    if (lists.tl_history) {
      const Scene::TlHistory h = lists.tl_history();
      a.lists = h.values;
      a.lists_columns = h.columns;
      a.was_ul = h.was_ul;
      a.ul_steps = h.ul_steps;
    }
  }
  a.measure = model.surface_measure();
  a.temperature = state->start_temperatures().of_all();
  a.h = model.settings_in_use().h;
  a.stress = model.units().stress;
  a.density = model.units().density;
  a.energy = model.units().energy;
  a.columns = (int) wanted.size();
  return a;
}

void ComputeSPHTMAtom::run_output(double *value)
{
  tm_output_args a = output_args();
  a.wanted = wanted.data();
  a.value = value;
  state->loops().blocks(atom->nlocal, [&](int begin, int end) {
    for (int i = begin; i < end; i++) tm_output(i, &a);
  });
}

void ComputeSPHTMAtom::check_current()
{
  scene->state("Compute sph/tm/atom");    // it may have gone since the last run
  scene->check_current(state, fmt::format("Compute sph/tm/atom {}", id));
}

void ComputeSPHTMAtom::compute_peratom()
{
  invoked_peratom = update->ntimestep;
  check_current();
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
  const Scene::Adaptation &lists = scene->adaptation();
  const double *level = lists.levels ? lists.levels() : nullptr;
  for (size_t k = 0; level && k < wanted.size(); k++)
    for (int i = 0; wanted[k] == TM_OUT_LEVEL && i < atom->nlocal; i++)
      if (atom->mask[i] & groupbit) value[i * wanted.size() + k] = level[i];
}

double ComputeSPHTMAtom::memory_usage() { return (double) nmax * wanted.size() * sizeof(double); }
