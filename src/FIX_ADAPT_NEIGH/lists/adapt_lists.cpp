#include "adapt_lists.h"

#include "argument.h"
#include "fix_sph_tm.h"
#include "pair_sph_tm.h"

#include "atom.h"
#include "error.h"
#include "lammps.h"
#include "neighbor.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

bool AdaptLists::keyword(Keywords &k)
{
  if (k.is("threshold")) threshold = k.take("inf") ? INFINITY : k.not_negative();
  else if (k.is("stretch")) stretch = k.take("inf") ? INFINITY : k.positive();
  else if (k.is("approach")) approach = k.take("inf") ? INFINITY : k.within(0.0, 0.5);
  else if (k.is("margin")) lists.set_skin(k.within(0.0, 1.0));
  else if (k.is("rows")) lists.set_rows(k.integer(1, TM_SEARCH_MOST));
  else return false;
  return true;
}

void AdaptLists::init()
{
  LAMMPS *lmp = parts.host();
  if (sizeof(tagint) != sizeof(int))
    lmp->error->all(FLERR, "Fix adapt/neigh threshold: rows sort by tags of 32 bits; build LAMMPS with SMALLBIG");
  const Neighbor *of_lammps = lmp->neighbor;
  if (of_lammps->nex_type || of_lammps->nex_group || of_lammps->nex_mol)
    lmp->error->all(FLERR, "Fix adapt/neigh threshold: its rows know nothing of 'neigh_modify exclude'; leave that "
                           "out, and say with 'pair_coeff i j none' which types do not meet");
  lists.init(keeps());
  Backend &loops = parts.body().loops();
  lists.move_to(loops);
  map.move_to(loops);
  if (keeps()) stored.init(threshold, stretch, approach);
  parts.update_packed_size();
}

// entries of rows become tags: particles are about to get other indices
void AdaptLists::begin_renumbering()
{
  if (lists.has_skin() && !map.in_use() && lists.exist())
    map.begin(parts.pair().loop_tags(), parts.owned_and_ghosts());
}

void AdaptLists::setup_pre_exchange()
{
  begin_renumbering();
  lists.forget();    // types may have changed since the last run
}

void AdaptLists::end_of_step()
{
  if (keeps()) stored.end_of_step();
}

void AdaptLists::post_run()
{
  begin_renumbering();
  if (keeps()) stored.post_run();
}

void AdaptLists::changed(bool moved, bool renamed)
{
  if (keeps()) stored.changed(moved, renamed);
}

bool AdaptLists::restore(const double *value, size_t n)
{
  if (!stored.restore(value, n)) return false;
  if (!keeps()) return true;
  lists.set_room((int) value[0]);
  if (lists.room() > 0) stored.pairs().make_room(parts.host()->atom->nmax);
  parts.update_packed_size();
  return true;
}

double AdaptLists::output(int k)
{
  if (!keeps() && k < 2) return k == 0 ? 1.0 : 0.0;
  const double mine = k == 0 ? stored.share_of_last_step() : k == 1 ? stored.steps_of_all() : lists.entries();
  double sum;
  MPI_Allreduce(&mine, &sum, 1, MPI_DOUBLE, MPI_SUM, parts.host()->world);
  return sum / std::max((double) parts.host()->atom->natoms, 1.0);
}

void *AdaptLists::extract(const char *what)
{
  if (strcmp(what, RowSource::NAME) == 0) return static_cast<RowSource *>(this);
  if (strcmp(what, "memory of lists") == 0) return keeps() ? (void *) stored.pairs().history_read() : nullptr;
  return nullptr;
}

/* ---------------------------------------------------------------------- for pair sph/tm */

void AdaptLists::renew(bool renumbered)
{
  renumbered = renumbered || !lists.fits(parts.owned());
  if (renumbered) lists.renumbered();
  if (keeps()) stored.renew(renumbered);
  else if (lists.may_remain()) {
    const int all = parts.owned_and_ghosts();
    const bool same = !renumbered || (all == parts.owned() && map.same_indices(parts.pair().loop_tags(), all));
    map.end();
    lists.search_moved(!same || !lists.are_good() || !lists.has_skin());
  } else
    lists.search_all();
}

tm_rows AdaptLists::mechanical() { return keeps() && stored.only() ? stored.pairs().mechanical() : lists.rows(); }

int AdaptLists::searched(tm_rates_args &a)
{
  a.rows = lists.rows();
  return keeps() ? stored.ul_particles(&a.which) : parts.owned();
}

void AdaptLists::kept_moments(const tm_rates_args &rates, unsigned effects)
{
  if (keeps()) stored.correct(rates, effects);
}

void AdaptLists::show(const tm_records &rec)
{
  if (keeps()) stored.communicate(rec);
}

void AdaptLists::kept_rates(const tm_rates_args &rates, unsigned effects)
{
  if (keeps()) stored.rates(rates, effects);
}

}    // namespace SPHTM_NS
