#include "adapt_lists.h"

#include "contact_probe.h"

#include "argument.h"

#include "atom.h"
#include "comm.h"
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
  if (has_tl() && parts.state().effect_plan().separate(std::isinf(threshold))) parts.state().plan_changed();
  lists.init(has_tl());
  Backend &loops = parts.state().loops();
  lists.move_to(loops);
  map.move_to(loops);
  if (has_tl()) stored.init(threshold, stretch, approach);
  parts.update_packed_size();
}

// entries of rows become tags: particles are about to get other indices
void AdaptLists::begin_renumbering()
{
  if (lists.has_skin() && !map.in_use() && lists.exist())
    map.begin(parts.rows().loop_tags(), parts.owned(), parts.owned_and_ghosts());
}

void AdaptLists::setup_pre_exchange()
{
  begin_renumbering();
  lists.forget();    // types may have changed since the last run
}

// what kept pairs hold together does not come off
void AdaptLists::warn_of_tools()
{
  if (warned_tools || !std::isinf(threshold) || !parts.state().has(TM_FX_PLASTICITY)) return;
  for (const ContactProbe *p : parts.scene().contact_probes()) {
    if (!(p->box().top_speed > 0.0)) continue;
    warned_tools = true;
    if (parts.host()->comm->me == 0)
      parts.host()->error->warning(
          FLERR,
          "Fix adapt/neigh threshold inf: pairs are kept for the whole run, so metal parts only by "
          "damage: a chip that fix contact/tri {} cuts stays tied to the work piece, with forces "
          "that are too large (it is for what is pressed, bent or pulled)",
          p->tool_name);
    return;
  }
}

// pairs of both kinds are not in one pass
void AdaptLists::setup()
{
  warn_of_tools();
  const ParticleState &state = parts.state();
  if (warned_slow || !has_tl() || std::isinf(threshold) || !state.has(TM_FX_CORRECTION) || !state.has(TM_FX_HOURGLASS))
    return;
  warned_slow = true;
  if (parts.host()->comm->me == 0)
    parts.host()->error->warning(
        FLERR,
        "Fix adapt/neigh threshold {}: with gradient correction and hourglass control, the "
        "default of pair_style sph/tm, a threshold between 0 and inf takes 1.5 to 1.7 times the "
        "time of 'threshold 0 margin 0.15', which is the fastest{}",
        threshold,
        state.has(TM_FX_PLASTICITY) ? "; metal that flows is not shifted with it: chips tear, and forces of cuts came "
                                      "out up to 16 % lower; and shocks ring, without their bulk viscosity"
                                    : "");
}

void AdaptLists::end_of_step()
{
  if (has_tl()) stored.end_of_step();
}

void AdaptLists::post_run()
{
  begin_renumbering();
  if (has_tl()) stored.post_run();
}

void AdaptLists::changed(bool moved, bool renamed)
{
  if (has_tl()) stored.changed(moved, renamed);
}

bool AdaptLists::restore(const double *value, size_t n)
{
  if (!stored.restore(value, n)) return false;
  if (!has_tl()) return true;
  lists.set_room((int) value[0]);
  if (lists.room() > 0) stored.pairs().make_room(parts.host()->atom->nmax);
  parts.update_packed_size();
  return true;
}

double AdaptLists::output(int k)
{
  if (!has_tl() && k < 2) return k == 0 ? 1.0 : 0.0;
  const double mine = k == 0 ? stored.share_of_last_step() : k == 1 ? stored.steps_of_all() : lists.entries();
  double sum;
  MPI_Allreduce(&mine, &sum, 1, MPI_DOUBLE, MPI_SUM, parts.host()->world);
  return sum / std::max((double) parts.host()->atom->natoms, 1.0);
}

void AdaptLists::offer(Scene::Adaptation &a)
{
  a.rows = this;
  if (has_tl())
    a.tl_history = [this]() -> Scene::TlHistory {
      return {stored.pairs().history_read(), TM_TL_HISTORY, TM_TL_WAS_UL, TM_TL_UL_STEPS};
    };
}

/* ---------------------------------------------------------------------- for pair sph/tm */

void AdaptLists::renew(bool renumbered)
{
  renumbered = renumbered || !lists.fits(parts.owned());
  if (renumbered) lists.renumbered();
  if (has_tl()) stored.renew(renumbered);
  else if (lists.may_remain()) {
    const int all = parts.owned_and_ghosts();
    const bool same = !renumbered || (all == parts.owned() && map.same_indices(parts.rows().loop_tags(), all));
    map.end();
    lists.search_moved(!same || !lists.are_good() || !lists.has_skin());
  } else lists.search_all();
}

tm_rows AdaptLists::mechanical() { return has_tl() && stored.only() ? stored.pairs().mechanical() : lists.rows(); }

int AdaptLists::ul_rows(tm_rates_args &a)
{
  a.rows = lists.rows();
  return has_tl() ? stored.ul_particles(&a.which) : parts.owned();
}

void AdaptLists::tl_corrections(const tm_rates_args &rates, unsigned effects)
{
  if (has_tl()) stored.correct(rates, effects);
}

void AdaptLists::tl_export(const tm_records &rec)
{
  if (has_tl()) stored.communicate(rec);
}

void AdaptLists::tl_rates(const tm_rates_args &rates, unsigned effects)
{
  if (has_tl()) stored.rates(rates, effects);
}

}    // namespace SPHTM_NS
