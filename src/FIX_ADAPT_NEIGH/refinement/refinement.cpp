#include "refinement.h"

#include "argument.h"
#include "contact_probe.h"

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "modify.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

Refinement::Refinement(AdaptParts &all) :
    AdaptPart(all), in(all), cloud(all), remap(all, cloud), levels(all, in), split(all, in, cloud, remap, levels),
    merge(all, in, cloud, remap, levels), relaxation(all, in, cloud, remap, levels)
{
}

// all keywords are read
void Refinement::ready()
{
  in.check();
  const bool has_pair = parts.scene().has_pair();
  if (has_pair) in.make_pattern(parts.model().settings_in_use().kernel);
  parts.scene().state("Fix adapt/neigh refine").need(TM_FX_SMOOTHING, "particles are refined");
  Atom *atom = lmp()->atom;
  if (atom->rmass_flag) return;
  lmp()->modify->add_fix(fmt::format("{}_mass all property/atom rmass ghost yes", parts.id()));
  for (int i = 0; has_pair && parts.model().types() && atom->rmass_flag && i < atom->nlocal; i++)
    if (atom->rmass[i] == 0.0) atom->rmass[i] = parts.model().particle_mass(atom->type[i]);
}

/* ---------------------------------------------------------------------- calls of LAMMPS */

bigint Refinement::next_check() const
{
  const bigint now = lmp()->update->ntimestep;
  return (now / in.every + 1) * in.every;
}

// children that lie as a lattice of half the spacing does: others feel a tool earlier or later than whole particles
void Refinement::warn_of_tools()
{
  const double half = 0.5 / parts.model().settings_in_use().ratio;
  const bool lattice = in.kind == TM_SPLIT_SQUARE || in.kind == TM_SPLIT_CUBE;
  if (warned_tools || parts.scene().contact_probes().empty() || (lattice && fabs(in.epsilon - half) < 0.05 * half))
    return;
  warned_tools = true;
  if (lmp()->comm->me == 0)
    lmp()->error->warning(
        FLERR,
        "Fix adapt/neigh refine {} epsilon {:.6g}: children that do not lie half a spacing apart meet fix "
        "contact/tri {} too late (forces came out 12 to 16 % low): take {} epsilon {:.5g}",
        tm_split_name(in.kind), in.epsilon, parts.scene().contact_probes().front()->tool_name,
        in.pattern.dim == 3 ? "cube" : "square", half);
}

void Refinement::init()
{
  warn_of_tools();
  in.make_pattern(parts.model().settings_in_use().kernel);
  in.when.init(in.every);
  in.coarsen_when.init(in.every);
  forget_plans();
  warn_of_lost_levels();
  relax_at = apply_at = -1;
  const double least = *std::min_element(in.pattern.mass, in.pattern.mass + in.pattern.n);
  parts.rows().make_room_for(pow(least, (double) in.most_level / in.pattern.dim));
  const bigint now = lmp()->update->ntimestep;
  lmp()->modify->addstep_compute_all(now % in.every == 0 ? now : next_check());
}

void Refinement::setup()
{
  if (lmp()->update->ntimestep % in.every == 0) decide();
}

void Refinement::end_of_step()
{
  const Update *update = lmp()->update;
  if (update->ntimestep == relax_at) {
    relax_at = -1;
    relaxation.run();
  }
  // the last step is looked at by the set-up of the next run: particles may change in between
  if (update->ntimestep % in.every == 0 && update->ntimestep != update->laststep) decide();
}

void Refinement::forget_plans()
{
  split.clear();
  merge.clear();
  touched.clear();
  pending = false;
}

void Refinement::decide()
{
  forget_plans();
  parts.state().atoms().to_host();
  Modify *modify = lmp()->modify;
  modify->clearstep_compute();
  const std::vector<char> wanted = mark();
  modify->addstep_compute(next_check());

  double mine[2] = {0, 0}, all[2];
  for (char c : wanted) {
    mine[0] += c == REFINE_SPLIT;
    mine[1] += c == REFINE_BACK;
  }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, lmp()->world);
  if (all[0] + all[1] == 0.0) return;

  const Atom *atom = lmp()->atom;
  cloud.take_state();
  for (int i = 0; i < atom->nlocal; i++) {
    double *r = cloud.row(i);
    r[TM_CLOUD_MARK] = wanted[i];
    r[TM_CLOUD_LEVEL] = levels.level(i);
    r[TM_CLOUD_FAMILY] = levels.family(i);
  }
  cloud.forward();
  for (int i = 0; i < atom->nlocal; i++)
    if (wanted[i] == REFINE_SPLIT) split.plan(i);
  if (all[1] > 0.0) merge.plan();
  double work = (double) (split.planned() + merge.planned()), total;
  MPI_Allreduce(&work, &total, 1, MPI_DOUBLE, MPI_SUM, lmp()->world);
  pending = total > 0.0;
  if (!pending) return;
  touched = merge.plan_leaving();
  apply_at = lmp()->update->ntimestep + 1;
  parts.renew_lists();
  split.foresee_time_step();
}

// what is to be done to each particle
std::vector<char> Refinement::mark()
{
  const Atom *atom = lmp()->atom;
  const tm_material *material = parts.model().materials();
  std::vector<char> what(atom->nlocal, REFINE_NOTHING);
  const std::vector<char> splits = in.when.hold(cloud);
  std::vector<char> merges;
  if (in.coarsen == RefineInput::WHEN) merges = in.coarsen_when.hold(cloud);
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & parts.group_bit()) || material[atom->type[i]].body != TM_BODY_SOLID) continue;
    const bool may_merge = in.coarsen == RefineInput::FALLEN || (in.coarsen == RefineInput::WHEN && merges[i]);
    if (splits[i] && levels.level(i) < in.most_level) what[i] = REFINE_SPLIT;
    else if (may_merge && levels.level(i) > 0 && !splits[i]) what[i] = REFINE_BACK;
  }
  return what;
}

void Refinement::pre_exchange()
{
  if (!pending || apply_at != lmp()->update->ntimestep) return;
  parts.state().atoms().to_host();
  split.report_levels();
  Atom *atom = lmp()->atom;
  if (atom->map_style != Atom::MAP_NONE) atom->map_clear();
  atom->nghost = 0;
  atom->avec->clear_bonus();
  split.drop_outside();
  for (int i : touched) levels.set_fresh(i, true);
  if (in.sweeps) relax_at = lmp()->update->ntimestep;
  split.make();
  merge.make();
  merge.remove_leaving();
  const bigint mine = atom->nlocal;
  MPI_Allreduce(&mine, &atom->natoms, 1, MPI_LMP_BIGINT, MPI_SUM, lmp()->world);
  if (atom->map_style != Atom::MAP_NONE) {
    atom->map_init();
    atom->map_set();
  }
  parts.state().atoms().host_changed();
  forget_plans();
  const tm_size_range r = parts.state().sizes();
  parts.rows().cover_sizes(std::max(r.largest_h, parts.model().covered_h()), r.smallest_dp);
}

/* ---------------------------------------------------------------------- between runs */

// families are IDs
void Refinement::changed(bool, bool renamed)
{
  if (!renamed) return;
  levels.forget_families();
  const bool any = levels.any();
  if (any && in.coarsen != RefineInput::NEVER && lmp()->comm->me == 0)
    lmp()->error->warning(FLERR, "Fix adapt/neigh coarsen: particles have got other IDs since the last run: those that "
                                 "were split before are not merged any more ('delete_atoms ... compress no' leaves the "
                                 "IDs as they are)");
}

// particles of another such fix, that is gone
void Refinement::warn_of_lost_levels()
{
  if (asked_levels) return;
  asked_levels = true;
  const double least = parts.state().sizes().smallest_dp;
  const bool any = levels.any();
  if (!any && parts.state().history().begun() && least < 0.99 * parts.model().settings_in_use().spacing &&
      lmp()->comm->me == 0)
    lmp()->error->warning(FLERR, "Fix adapt/neigh refine: some particles are smaller than the spacing of pair_style; "
                                 "where another fix adapt/neigh has split them before, that is forgotten: they are of "
                                 "level 0 and may be split again");
}

/* ---------------------------------------------------------------------- restart, outputs */

namespace {
enum { SPLITS, MERGES, OUTSIDE, MASS, PX, PY, PZ, LX, LY, LZ, KINETIC, ELASTIC, SUMS };
enum { KIND = SUMS, EPSILON, ALPHA, LEVELS, NEXT_TAG, REPORTED, SAVED };
}    // namespace

std::vector<double> Refinement::sums() const
{
  const tm_content &error = remap.errors();
  const double mine[SUMS] = {split.made(),     merge.made(),     split.kept_at_box(), error.mass,
                             error.momentum.x, error.momentum.y, error.momentum.z,    error.angular.x,
                             error.angular.y,  error.angular.z,  error.kinetic,       error.elastic};
  std::vector<double> all(SUMS);
  MPI_Allreduce(mine, all.data(), SUMS, MPI_DOUBLE, MPI_SUM, lmp()->world);
  return all;
}

std::vector<double> Refinement::state()
{
  std::vector<double> s = sums();
  s.insert(s.end(), {(double) in.kind, in.epsilon, in.alpha, (double) in.most_level, split.tag_of_next(),
                     (double) split.reported()});
  return s;
}

bool Refinement::restore(const double *s, size_t n)
{
  if (n != SAVED || !is_whole(s[KIND], 0, TM_SPLIT_KINDS - 1) || !is_whole(s[LEVELS], 1, 8) ||
      !is_whole(s[NEXT_TAG], 0, MAXTAGINT) || !is_whole(s[REPORTED], 0, 8))
    return false;
  const auto text = [](double k, double e, double a, double l) {
    return fmt::format("{} epsilon {:.8g} alpha {:.8g} level {}", tm_split_name((int) k), e, a, (int) l);
  };
  if (s[KIND] != in.kind || s[EPSILON] != in.epsilon || s[ALPHA] != in.alpha || s[LEVELS] != in.most_level)
    lmp()->error->all(FLERR, "Fix adapt/neigh refine {}: the restart file was written with {}; write the same",
                      text(in.kind, in.epsilon, in.alpha, in.most_level),
                      text(s[KIND], s[EPSILON], s[ALPHA], s[LEVELS]));
  split.restore(s[NEXT_TAG], (int) s[REPORTED]);
  if (lmp()->comm->me) return true;
  split.restore_counts(s[SPLITS], s[OUTSIDE]);
  merge.restore(s[MERGES]);
  tm_content error = tm_content_nothing();
  error.mass = s[MASS];
  error.momentum = tm_vec(s[PX], s[PY], s[PZ]);
  error.angular = tm_vec(s[LX], s[LY], s[LZ]);
  error.kinetic = s[KINETIC];
  error.elastic = s[ELASTIC];
  remap.restore(error);
  return true;
}

std::vector<std::string> Refinement::outputs() const
{
  // clang-format off
  std::vector<std::string> names = {"splits", "merges", "kept at the box", "smallest h", "mass error", "momentum error",
                                    "angular momentum error", "kinetic energy error", "elastic energy error"};
  // clang-format on
  for (int l = 0; l <= in.most_level; l++) names.push_back(fmt::format("particles of level {}", l));
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
  const UnitScale &unit = parts.model().units();
  const std::vector<double> s = sums();
  std::vector<double> count(in.most_level + 1, 0.0), all(in.most_level + 1);
  for (int i = 0; i < atom->nlocal; i++) count[(int) levels.level(i)] += 1.0;
  MPI_Allreduce(count.data(), all.data(), in.most_level + 1, MPI_DOUBLE, MPI_SUM, lmp()->world);
  const tm_vec3 momentum = tm_vec(s[PX], s[PY], s[PZ]), angular = tm_vec(s[LX], s[LY], s[LZ]);
  // clang-format off
  summed = {s[SPLITS], s[MERGES], s[OUTSIDE], parts.state().sizes().smallest_h, s[MASS], tm_vec_norm(momentum),
            tm_vec_norm(angular), s[KINETIC] / unit.energy, s[ELASTIC] / unit.energy};
  // clang-format on
  summed.insert(summed.end(), all.begin(), all.end());
}

}    // namespace SPHTM_NS
