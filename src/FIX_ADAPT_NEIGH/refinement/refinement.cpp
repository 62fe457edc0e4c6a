#include "refinement.h"

#include "argument.h"
#include "fix_adapt_neigh.h"
#include "fix_sph_tm.h"
#include "pair_sph_tm.h"

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

Refinement::Refinement(FixAdaptNeigh &owner) :
    AdaptPart(owner), when(owner, "refine"), coarsen_when(owner, "coarsen"), cloud(owner), error(tm_content_nothing())
{
}

LAMMPS *Refinement::lmp() const { return fix.host(); }

/* ---------------------------------------------------------------------- input */

bool Refinement::keyword(Keywords &k)
{
  if (k.is("refine")) read_refine(k);
  else if (k.is("coarsen")) {
    coarsen = k.second("fallen", "when") ? WHEN : FALLEN;
    if (coarsen == WHEN) coarsen_when.read(k.what("when"), k);
  } else
    return false;
  return true;
}

// refine <pattern> epsilon E alpha A when <criteria> [level N] [every M] [velocity parent|linear] [settle N]
void Refinement::read_refine(Keywords &k)
{
  Error *error = lmp()->error;
  if (kind >= 0) error->all(FLERR, "{} is given twice; join criteria with and, or", k.what());
  read_pattern(k);
  while (k.option(options())) {
    if (k.is("epsilon")) read_epsilon(k);
    else if (k.is("alpha")) alpha = k.within(0.0, 1.0);
    else if (k.is("level")) most_level = k.integer(1, 8);
    else if (k.is("every")) every = k.integer(1, 1000000000);
    else if (k.is("settle")) sweeps = k.integer(0, 100);
    else if (k.is("velocity")) linear = k.second("parent", "linear");
    else {
      if (!when.empty()) error->all(FLERR, "{} is given twice; join criteria with and, or", k.what());
      when.read(k.what(), k);
    }
  }
}

void Refinement::read_epsilon(Keywords &k)
{
  epsilon = k.positive();
  if (epsilon <= 1.0) return;
  lmp()->error->all(FLERR, "{} must be above 0 and at most 1, got {}: it is how far children are from the particle "
                           "that is split, in its smoothing lengths; beyond 1 they are among its neighbors; 0.35 to 0.5"
                           " is usual",
                    k.what(), k.given());
}

void Refinement::read_pattern(Keywords &k)
{
  Error *error = lmp()->error;
  std::string known;
  for (int n = 0; n < TM_SPLIT_KINDS; n++) known += std::string(n ? ", " : "") + tm_split_name(n);
  if (!k.rest()) error->all(FLERR, "{} needs a pattern: {}", k.what(), known);
  for (int n = 0; n < TM_SPLIT_KINDS && kind < 0; n++)
    if (k.take(tm_split_name(n))) kind = n;
  if (kind < 0) error->all(FLERR, "{}: unknown pattern {}; known are {}", k.what(), k.value(), known);
  const int dim = lmp()->domain->dimension;
  if (tm_split_dim(kind) != dim)
    error->all(FLERR, "{} {}: the pattern has {} dimensions, the run {}", k.what(), tm_split_name(kind),
               tm_split_dim(kind), dim);
}

void Refinement::make_pattern(int kernel)
{
  const int status = tm_split_make(kind, kernel, epsilon, alpha, &pattern);
  if (status == TM_SPLIT_OK) return;
  std::string masses;
  for (int k = 0; k < pattern.n; k++) masses += fmt::format(" {:.4g}", pattern.mass[k]);
  const bool none = pattern.mass[0] > 0.5;    // all in the centre
  lmp()->error->all(FLERR, "Fix adapt/neigh refine {} epsilon {:.6g} alpha {:.6g} with the {} kernel {}; take {}",
                    tm_split_name(kind), epsilon, alpha, PairSPHTM::kernel_name(kernel),
                    status == TM_SPLIT_SINGULAR
                        ? "puts the children so close together that their masses are not determined"
                        : fmt::format("would give {} of the children {} mass, in parts of the whole:{}",
                                      none ? "all but one" : "one", none ? "no" : "a negative", masses),
                    status == TM_SPLIT_NEGATIVE && none ? "a smaller alpha" : "a larger epsilon");
}

// all keywords are read
void Refinement::ready()
{
  Error *error = lmp()->error;
  if (kind < 0) error->all(FLERR, "Fix adapt/neigh coarsen needs the keyword refine: it merges what was split");
  const std::string what = std::string("Fix adapt/neigh refine ") + tm_split_name(kind);
  if (epsilon == 0.0 || alpha == 0.0)
    error->all(FLERR, "{} needs '{} <number>', in smoothing lengths of the particle that is split", what,
               epsilon == 0.0 ? "epsilon" : "alpha");
  if (when.empty()) error->all(FLERR, "{} needs 'when' with a criterion", what);
  auto *pair = dynamic_cast<PairSPHTM *>(lmp()->force->pair_match("^sph/tm", 0));
  if (pair) make_pattern(pair->settings_in_use().kernel);
  FixSPHTM::of(lmp(), "Fix adapt/neigh refine")->need(TM_FX_SMOOTHING, "particles are refined");
  if (lmp()->atom->rmass_flag) return;
  lmp()->modify->add_fix(fmt::format("{}_mass all property/atom rmass ghost yes", fix.id));
  if (pair) pair->give_masses();
}

/* ---------------------------------------------------------------------- calls of LAMMPS */

bigint Refinement::next_check() const
{
  const bigint now = lmp()->update->ntimestep;
  return (now / every + 1) * every;
}

void Refinement::init()
{
  make_pattern(fix.pair().settings_in_use().kernel);
  when.init(every);
  coarsen_when.init(every);
  forget_plans();
  warn_of_lost_levels();
  tools.clear();
  for (Fix *f : lmp()->modify->get_fix_by_style("^contact/tri"))
    if (auto *tool = dynamic_cast<ContactProbe *>(f)) tools.push_back(tool);
  settle_at = apply_at = -1;
  const double least = *std::min_element(pattern.mass, pattern.mass + pattern.n);
  fix.pair().make_room_for(pow(least, (double) most_level / pattern.dim));
  const bigint now = lmp()->update->ntimestep;
  lmp()->modify->addstep_compute_all(now % every == 0 ? now : next_check());
}

void Refinement::setup()
{
  if (lmp()->update->ntimestep % every == 0) decide();
}

void Refinement::end_of_step()
{
  const Update *update = lmp()->update;
  if (update->ntimestep == settle_at) settle();
  // the last step is looked at by the set-up of the next run: particles may change in between
  if (update->ntimestep % every == 0 && update->ntimestep != update->laststep) decide();
}

void Refinement::forget_plans()
{
  splits.clear();
  merges.clear();
  leaving.clear();
  touched.clear();
  pending = false;
}

void Refinement::decide()
{
  forget_plans();
  fix.body().host_particles();
  Modify *modify = lmp()->modify;
  modify->clearstep_compute();
  const std::vector<char> wanted = mark();
  modify->addstep_compute(next_check());

  double mine[2] = {0, 0}, all[2];
  for (char c : wanted) {
    mine[0] += c == SPLIT;
    mine[1] += c == FALLEN_BACK;
  }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, lmp()->world);
  if (all[0] + all[1] == 0.0) return;

  const Atom *atom = lmp()->atom;
  cloud.take_state();
  for (int i = 0; i < atom->nlocal; i++) {
    double *r = cloud.row(i);
    r[TM_CLOUD_MARK] = wanted[i];
    r[TM_CLOUD_LEVEL] = level[i];
    r[TM_CLOUD_FAMILY] = level[i] > 0 ? family_at(i, (int) level[i]) : 0.0;
  }
  cloud.forward();
  for (int i = 0; i < atom->nlocal; i++)
    if (wanted[i] == SPLIT) plan_split(i);
  if (all[1] > 0.0) plan_merges();
  double work = (double) (splits.size() + merges.size()), total;
  MPI_Allreduce(&work, &total, 1, MPI_DOUBLE, MPI_SUM, lmp()->world);
  pending = total > 0.0;
  if (!pending) return;
  plan_leaving();
  apply_at = lmp()->update->ntimestep + 1;
  fix.renew_lists();
  foresee_time_step();
}

// what is to be done to each particle
std::vector<char> Refinement::mark()
{
  const Atom *atom = lmp()->atom;
  const tm_material *material = fix.pair().materials();
  std::vector<char> what(atom->nlocal, NOTHING);
  const std::vector<char> split = when.hold(cloud);
  std::vector<char> merge;
  if (coarsen == WHEN) merge = coarsen_when.hold(cloud);
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & fix.groupbit) || material[atom->type[i]].body != TM_BODY_SOLID) continue;
    if (split[i] && level[i] < most_level) what[i] = SPLIT;
    else if (coarsen != NEVER && level[i] > 0 && !split[i] && (coarsen == FALLEN || merge[i])) what[i] = FALLEN_BACK;
  }
  return what;
}

void Refinement::pre_exchange()
{
  if (!pending || apply_at != lmp()->update->ntimestep) return;
  fix.body().host_particles();
  report_levels();
  Atom *atom = lmp()->atom;
  if (atom->map_style != Atom::MAP_NONE) atom->map_clear();
  atom->nghost = 0;
  atom->avec->clear_bonus();
  drop_outside();
  for (int i : touched) {
    fix.neighborhood_changed(i);
    fresh[i] = 1.0;
  }
  if (sweeps) settle_at = lmp()->update->ntimestep;
  make_children();
  make_merged();
  remove_leaving();
  const bigint mine = atom->nlocal;
  MPI_Allreduce(&mine, &atom->natoms, 1, MPI_LMP_BIGINT, MPI_SUM, lmp()->world);
  if (atom->map_style != Atom::MAP_NONE) {
    atom->map_init();
    atom->map_set();
  }
  fix.body().host_particles_changed();
  forget_plans();
  const tm_size_range r = fix.body().sizes();
  fix.pair().cover_sizes(std::max(r.largest_h, fix.pair().covered_h()), r.smallest_dp);
}

/* ---------------------------------------------------------------------- values of particles */

void Refinement::grow(int nmax)
{
  level.resize(nmax, 0.0);
  fresh.resize(nmax, 0.0);
  family.resize((size_t) nmax * most_level, 0.0);
}

void Refinement::copy(int from, int to)
{
  level[to] = level[from];
  fresh[to] = fresh[from];
  for (int k = 1; k <= most_level; k++) family_at(to, k) = family_at(from, k);
}

void Refinement::set_new(int i)
{
  level[i] = fresh[i] = 0.0;
  for (int k = 1; k <= most_level; k++) family_at(i, k) = 0.0;
}

int Refinement::pack(int i, double *buf)
{
  *buf++ = level[i];
  *buf++ = fresh[i];
  for (int k = 1; k <= most_level; k++) *buf++ = family_at(i, k);
  return 2 + most_level;
}

int Refinement::unpack(int i, const double *buf)
{
  level[i] = *buf++;
  fresh[i] = *buf++;
  for (int k = 1; k <= most_level; k++) family_at(i, k) = *buf++;
  return 2 + most_level;
}

// families are IDs
void Refinement::changed(bool, bool renamed)
{
  if (!renamed) return;
  std::fill(family.begin(), family.end(), 0.0);
  const int n = lmp()->atom->nlocal;
  int mine = std::any_of(level.begin(), level.begin() + n, [](double l) { return l > 0.0; }), any;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, lmp()->world);
  if (any && coarsen != NEVER && lmp()->comm->me == 0)
    lmp()->error->warning(FLERR, "Fix adapt/neigh coarsen: particles have got other IDs since the last run: those that "
                                 "were split before are not merged any more ('delete_atoms ... compress no' leaves the "
                                 "IDs as they are)");
}

// particles of another such fix, that is gone
void Refinement::warn_of_lost_levels()
{
  if (asked_levels) return;
  asked_levels = true;
  const double least = fix.body().sizes().smallest_dp;
  const int n = lmp()->atom->nlocal;
  int mine = std::any_of(level.begin(), level.begin() + n, [](double l) { return l > 0.0; }), any;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, lmp()->world);
  if (!any && fix.body().begun() && least < 0.99 * fix.pair().settings_in_use().spacing && lmp()->comm->me == 0)
    lmp()->error->warning(FLERR, "Fix adapt/neigh refine: some particles are smaller than the spacing of pair_style; "
                                 "where another fix adapt/neigh has split them before, that is forgotten: they are of "
                                 "level 0 and may be split again");
}

// level, fresh or not, families
int Refinement::look(const double *row, int n, std::string &why) const
{
  if (n < 2 + most_level) why = fmt::format("{} values for refinement, {} expected", n, 2 + most_level);
  else if (!is_whole(row[0], 0, most_level)) why = fmt::format("level {}, 0 to {} expected", row[0], most_level);
  else if (!is_whole(row[1], 0, 1)) why = fmt::format("a mark of refinement {}, 0 or 1 expected", row[1]);
  for (int k = 1; why.empty() && k <= most_level; k++)
    if (!is_whole(row[1 + k], 0, MAXTAGINT)) why = fmt::format("family {} at level {}", row[1 + k], k);
  return why.empty() ? 2 + most_level : -1;
}

/* ---------------------------------------------------------------------- restart, outputs */

namespace {
enum { SPLITS, MERGES, OUTSIDE, MASS, PX, PY, PZ, LX, LY, LZ, KINETIC, ELASTIC, SUMS };
enum { KIND = SUMS, EPSILON, ALPHA, LEVELS, NEXT_TAG, TOLD, SAVED };
}    // namespace

std::vector<double> Refinement::sums() const
{
  const double mine[SUMS] = {n_splits,         n_merges,         n_outside,       error.mass,
                             error.momentum.x, error.momentum.y, error.momentum.z, error.angular.x,
                             error.angular.y,  error.angular.z,  error.kinetic,   error.elastic};
  std::vector<double> all(SUMS);
  MPI_Allreduce(mine, all.data(), SUMS, MPI_DOUBLE, MPI_SUM, lmp()->world);
  return all;
}

std::vector<double> Refinement::state()
{
  std::vector<double> s = sums();
  s.insert(s.end(), {(double) kind, epsilon, alpha, (double) most_level, next_tag, (double) levels_told});
  return s;
}

bool Refinement::restore(const double *s, size_t n)
{
  if (n != SAVED || !is_whole(s[KIND], 0, TM_SPLIT_KINDS - 1) || !is_whole(s[LEVELS], 1, 8) ||
      !is_whole(s[NEXT_TAG], 0, MAXTAGINT) || !is_whole(s[TOLD], 0, 8))
    return false;
  const auto text = [](double k, double e, double a, double l) {
    return fmt::format("{} epsilon {:.8g} alpha {:.8g} level {}", tm_split_name((int) k), e, a, (int) l);
  };
  if (s[KIND] != kind || s[EPSILON] != epsilon || s[ALPHA] != alpha || s[LEVELS] != most_level)
    lmp()->error->all(FLERR, "Fix adapt/neigh refine {}: the restart file was written with {}; write the same",
                      text(kind, epsilon, alpha, most_level), text(s[KIND], s[EPSILON], s[ALPHA], s[LEVELS]));
  next_tag = s[NEXT_TAG];
  levels_told = (int) s[TOLD];
  if (lmp()->comm->me) return true;
  n_splits = s[SPLITS];
  n_merges = s[MERGES];
  n_outside = s[OUTSIDE];
  error.mass = s[MASS];
  error.momentum = tm_vec(s[PX], s[PY], s[PZ]);
  error.angular = tm_vec(s[LX], s[LY], s[LZ]);
  error.kinetic = s[KINETIC];
  error.elastic = s[ELASTIC];
  return true;
}

std::vector<std::string> Refinement::outputs() const
{
  std::vector<std::string> names = {"splits", "merges", "kept at the box", "smallest h", "mass error", "momentum error",
                                    "angular momentum error", "kinetic energy error", "elastic energy error"};
  for (int l = 0; l <= most_level; l++) names.push_back(fmt::format("particles of level {}", l));
  return names;
}

double Refinement::output(int n)
{
  if (summed_at != lmp()->update->ntimestep || !lmp()->update->whichflag) sum_outputs();
  return summed[n];
}

void Refinement::sum_outputs()
{
  summed_at = lmp()->update->ntimestep;
  const Atom *atom = lmp()->atom;
  const UnitScale &unit = fix.pair().units();
  const std::vector<double> s = sums();
  std::vector<double> count(most_level + 1, 0.0), all(most_level + 1);
  for (int i = 0; i < atom->nlocal; i++) count[(int) level[i]] += 1.0;
  MPI_Allreduce(count.data(), all.data(), most_level + 1, MPI_DOUBLE, MPI_SUM, lmp()->world);
  const tm_vec3 momentum = tm_vec(s[PX], s[PY], s[PZ]), angular = tm_vec(s[LX], s[LY], s[LZ]);
  summed = {s[SPLITS], s[MERGES], s[OUTSIDE], fix.body().sizes().smallest_h, s[MASS], tm_vec_norm(momentum),
            tm_vec_norm(angular), s[KINETIC] / unit.energy, s[ELASTIC] / unit.energy};
  summed.insert(summed.end(), all.begin(), all.end());
}

}    // namespace SPHTM_NS
