/* SPH-TM: fix adapt/neigh, smoothing length. See doc/fix_adapt_neigh.rst. */
#include "adapt_smoothing.h"

#include "argument.h"
#include "neighbor_cutoff.h"
#include "search_loops.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

// lists reach this much further than the largest h needs, so that they are not widened at every turn
static constexpr double MARGIN = 1.05;

bool AdaptSmoothing::keyword(Keywords &k)
{
  if (!k.is("asph")) return false;
  LAMMPS *lmp = parts.host();
  if (mode != NONE) lmp->error->all(FLERR, "{} is given twice", k.what());
  mode = k.second("psi", "density") ? DENSITY : PSI;
  while (k.option(options())) {
    if (k.is("every")) every = k.integer(1, 1000000);
    else {
      k.need(2);
      least = k.within(0.0, 1.0, "lo");
      most = k.positive("hi");
      if (most < 1.0) lmp->error->all(FLERR, "{} hi must be at least 1, got {}", k.what(), k.given());
    }
  }
  rule.least = least;
  rule.most = most;
  // before init, so that no check takes particles of different mass for a mistake
  if (ParticleState *state = parts.scene().state()) state->need(TM_FX_SMOOTHING, "fix adapt/neigh has asph");
  return true;
}

void AdaptSmoothing::init()
{
  parts.state().need(TM_FX_SMOOTHING, "fix adapt/neigh has asph");
  if (!parts.state().has(TM_FX_SMOOTHING))
    parts.host()->error->all(FLERR, "Fix adapt/neigh asph needs the effect smoothing, which is forced off in fix "
                                    "sph/tm");
  const tm_size_range r = parts.state().sizes();
  smallest_h = r.smallest_h;
  largest_h = r.largest_h;
  parts.rows().cover_sizes(MARGIN * largest_h, r.smallest_dp);
  for (const AdaptPart *p : parts.used()) {
    const auto words = p->keywords();
    if (mode == PSI && std::find(words.begin(), words.end(), "refine") != words.end() && parts.host()->comm->me == 0)
      parts.host()->error->warning(FLERR,
                                   "Fix adapt/neigh asph psi with refine: psi counts neighbors, whose number changes "
                                   "where sizes meet; h goes wrong there by as much as a half, and bodies of several "
                                   "levels become too soft");
  }
  if (mode != PSI || !table.empty()) return;
  tm_asph_table t;
  tm_asph_make(parts.model().settings_in_use().kernel, parts.host()->domain->dimension, &t);
  table.live_in(parts.state().loops());
  table.assign(&t, 1);
  rule.table = table.host_read();
}

void AdaptSmoothing::setup() { follow(true); }

void AdaptSmoothing::end_of_step()
{
  if (parts.host()->update->ntimestep % every) return;
  follow(false);
  if (largest_h > parts.model().covered_h()) parts.renew_lists();
}

void AdaptSmoothing::follow(bool first)
{
  ParticleState &state = parts.state();
  const tm_rates_args &rates = parts.results().rate_args();
  tm_smoothing_args a;
  a.state = state.arrays();
  a.rec = rates.rec;
  a.rows = rates.rows;
  a.table = mode == PSI ? table.loop_read() : nullptr;
  a.first = first;
  a.least = least;
  a.most = most;
  const tm_size_range mine = SearchLoops::of(state.loops()).smoothing(state.loops(), parts.owned(), a, state.effects());
  const double low[2] = {-mine.largest_h, mine.smallest_h};
  double all[2];
  MPI_Allreduce(low, all, 2, MPI_DOUBLE, MPI_MIN, parts.host()->world);
  largest_h = -all[0];
  smallest_h = all[1];
}

// lists that are about to be renewed reach as far as the largest h needs
void AdaptSmoothing::pre_exchange()
{
  if (largest_h <= parts.model().covered_h()) return;
  parts.rows().cover_sizes(MARGIN * largest_h, parts.model().smallest_spacing());
  widen_neighbor_lists(parts.host());
  widened++;
}

double AdaptSmoothing::output(int n) { return n == 0 ? smallest_h : n == 1 ? largest_h : widened; }

void AdaptSmoothing::offer(Scene::Adaptation &a) { a.smoothing = &rule; }

}    // namespace SPHTM_NS
