#include "between_runs.h"

#include "adapt_part.h"
#include "loop_array.h"
#include "nearest_image.h"

#include "atom.h"
#include "lammps.h"

#include <algorithm>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

static constexpr double LEAST_MOVE = 1e-6;    // of the spacing

namespace {
// tags and positions of owned particles, which may be newer where the loops run
struct OnHost {
  explicit OnHost(AdaptParts &parts) : tags(parts.state().loops()), places(parts.state().loops())
  {
    const size_t n = parts.owned();
    Backend &loops = parts.state().loops();
    tags.resize(n + 1);
    places.resize(3 * n + 1);
    loops.copy(tags.loop_write(), parts.rows().loop_tags(), n * sizeof(int));
    loops.copy(places.loop_write(), parts.state().arrays().x, 3 * n * sizeof(double));
    tag = tags.host_read();
    x = places.host_read();
  }
  LoopArray<int> tags;
  LoopArray<double> places;
  const int *tag;
  const double *x;
};
}    // namespace

void BetweenRuns::remember(int i, int tag, const double *x)
{
  if (i >= (int) tag_then.size()) {
    const int nmax = parts.host()->atom->nmax;
    tag_then.resize(nmax, 0);
    x_then.resize(3 * (size_t) nmax, 0.0);
  }
  tag_then[i] = tag;
  std::copy_n(x, 3, &x_then[3 * (size_t) i]);
}

void BetweenRuns::compare(int i, int tag, const double *x)
{
  if (i >= (int) tag_then.size() || tag_then[i] == 0) return;
  const double *was = &x_then[3 * (size_t) i];
  double d[3] = {x[0] - was[0], x[1] - was[1], x[2] - was[2]};
  to_nearest_image(*parts.host()->domain, d);
  renamed = renamed || tag != tag_then[i];
  moved = moved || d[0] * d[0] + d[1] * d[1] + d[2] * d[2] > least * least;
}

void BetweenRuns::clear()
{
  on = moved = renamed = false;
  least = 0.0;
  tag_then.clear();
  x_then.clear();
}

void BetweenRuns::begin()
{
  if (parts.values().empty()) return;
  clear();
  if (!parts.is_complete()) return;
  on = true;
  least = LEAST_MOVE * parts.model().settings_in_use().spacing;
  const OnHost now(parts);
  for (int i = 0; i < parts.owned(); i++) remember(i, now.tag[i], now.x + 3 * (size_t) i);
}

// until the first set-up: commands may move and rename particles before
void BetweenRuns::begin_read(int i, int tag, const double *x)
{
  on = parts.scene().has_pair();
  least = on ? LEAST_MOVE * parts.model().settings_in_use().spacing : 0.0;
  if (on) remember(i, tag, x);
}

void BetweenRuns::end()
{
  if (parts.values().empty()) return;
  if (on && parts.is_complete()) {
    const OnHost now(parts);
    for (int i = 0; i < parts.owned(); i++) compare(i, now.tag[i], now.x + 3 * (size_t) i);
  }
  const int mine[2] = {moved, renamed};
  int any[2];
  MPI_Allreduce(mine, any, 2, MPI_INT, MPI_MAX, parts.host()->world);
  clear();
  if (any[0] || any[1])
    for (AdaptPart *p : parts.used()) p->changed(any[0], any[1]);
}

void BetweenRuns::copy(int from, int to)
{
  if (!on || from >= (int) tag_then.size()) return;
  const double *x = &x_then[3 * (size_t) from], at[3] = {x[0], x[1], x[2]};
  remember(to, tag_then[from], at);
}
void BetweenRuns::set_new(int i)
{
  if (on) remember(i, 0, parts.host()->atom->x[i]);
}
void BetweenRuns::leave(int i)
{
  const Atom *atom = parts.host()->atom;
  if (on) compare(i, (int) atom->tag[i], atom->x[i]);
}
void BetweenRuns::arrive(int i)
{
  const Atom *atom = parts.host()->atom;
  if (on) remember(i, (int) atom->tag[i], atom->x[i]);
}

}    // namespace SPHTM_NS
