/* SPH-TM: pair style sph/tm, what is made and checked before a run. See doc/pair_sph_tm.rst. */
#include "pair_sph_tm.h"

#include "fix_sph_tm.h"
#include "restart_block.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

static bool is_default_skin(const char *unit_style, double skin)
{
  static const struct { const char *style; double skin; } defaults[] = {
      {"lj", 0.3}, {"real", 2.0}, {"metal", 2.0}, {"si", 0.001}, {"cgs", 0.1}, {"electron", 2.0},
      {"micro", 0.1}, {"nano", 0.1}};
  return std::any_of(std::begin(defaults), std::end(defaults),
                     [&](const auto &d) { return strcmp(unit_style, d.style) == 0 && skin == d.skin; });
}

void PairSPHTM::init_style()
{
  for (int i = 1; i <= atom->ntypes; i++)
    if (material[i].rho0 <= 0.0)
      error->all(FLERR, "Pair sph/tm: no material for atom type {0}; write 'pair_coeff {0} {0} {1}"
                        "<file> <card>' or the constants inline", i,
                 force->pair == this ? "" : "sph/tm ");
  unit = unit_scale(lmp);
  lattice = tm_lattice_sums(set.kernel, domain->dimension, set.ratio);
  heat_rate = lattice.heat_rate;
  list_h = set.h;
  least_spacing = set.spacing;
  surface_scale = tm_surface_make(set.kernel, domain->dimension, set.spacing, set.h, TM_SURFACE_THRESHOLD);
  complete_laws();
  compare_with_restart();

  fix = FixSPHTM::of(lmp, "Pair style sph/tm");
  if (modify->get_fix_by_style("^sph/tm$").size() > 1)
    error->all(FLERR, "More than one fix sph/tm: one owns the state of all particles of pair style sph/tm; remove "
                      "the others");
  if (!restart_fix.empty() && !fix->restored())
    error->all(FLERR, "Fix {} sph/tm: the {} holds the state of the particles under the fix ID {}; write "
                      "'fix {} ... sph/tm ...' once, after read_restart", fix->id, restart_file_name(lmp), restart_fix,
               restart_fix);
  if (set.plane_stress && domain->dimension != 2)
    error->all(FLERR, "Pair style sph/tm plane stress needs dimension 2");

  if (utils::strmatch(force->pair_style, "^hybrid/scaled"))
    error->all(FLERR, "Pair style sph/tm does not work in hybrid/scaled: its forces belong to the stress that it keeps, which "
                      "no factor scales; use hybrid or hybrid/overlay");
  check_volume();
  check_masses();
  if (set.mixed) check_mixed();

  // the skin of the unit style's default is meant for molecules: take a tenth of the reach
  const double reach = tm_kernel_support(set.kernel) * set.h;
  if (is_default_skin(update->unit_style, neighbor->skin)) {
    neighbor->skin = 0.1 * reach;
    if (comm->me == 0)
      utils::logmesg(lmp, "sph/tm: neighbor skin {:.6g}, a tenth of the reach\n", neighbor->skin);
  }
  check_bins();
  check_list_size(least_spacing);
  make_tables();
  find_row_source();
  if (!row_source) neighbor->add_request(this, NeighConst::REQ_FULL);
}

// fix adapt/neigh with lists of its own
void PairSPHTM::find_row_source()
{
  row_source = nullptr;
  int dim;
  for (Fix *f : modify->get_fix_by_style("^adapt/neigh"))
    if (auto *source = (RowSource *) f->extract(RowSource::NAME, dim)) row_source = source;
}

void PairSPHTM::init_list(int, NeighList *ptr) { list = ptr; }

double PairSPHTM::init_one(int i, int j)
{
  if (setflag[i][j] == 0) error->all(FLERR, "Pair sph/tm: no law for types {} and {}", i, j);
  return tm_kernel_support(set.kernel) * set.h;
}

void PairSPHTM::Tables::live_in(Backend &loops)
{
  material.live_in(loops);
  for (auto *a : {&conductance, &young, &effusivity, &gradient, &share}) a->live_in(loops);
  law.live_in(loops);
  touch.live_in(loops);
}

void PairSPHTM::make_tables()
{
  const int n = atom_types + 1;
  const double T = fix->start_temperature();
  std::vector<double> conductance(n * n), young(n), effusivity(n);
  std::vector<tm_body_law> contact(n * n);
  std::vector<int> touch(n * n);
  bool conducts = false;
  for (int k = 0; k < n * n; k++) {
    conductance[k] = laws[k].conductance > 0.0 ? laws[k].conductance * lattice.interface * lattice.gradient : 0.0;
    conducts = conducts || conductance[k] > 0.0;
    contact[k] = laws[k].contact;
    touch[k] = laws[k].meeting == CONTACT;
  }
  for (int t = 1; t < n; t++) {
    const tm_material &m = material[t];
    young[t] = m.young;
    effusivity[t] = m.heat ? tm_effusivity(tm_conductivity(&m, T), tm_capacity(&m, T), m.rho0) : 0.0;
  }
  tables.material.assign(material.data(), n);
  tables.conductance.assign(conductance.data(), conducts ? n * n : 0);
  tables.law.assign(contact.data(), n * n);
  tables.touch.assign(touch.data(), n * n);
  tables.young.assign(young.data(), n);
  tables.effusivity.assign(effusivity.data(), n);
  std::vector<double> share(set.art_balanced && set.art_eps > 0.0 ? TM_GRADIENT_ENTRIES : 0);
  if (!share.empty()) tm_tensile_table(set.kernel, domain->dimension, set.art_n, share.data());
  tables.share.assign(share.data(), share.size());
}
