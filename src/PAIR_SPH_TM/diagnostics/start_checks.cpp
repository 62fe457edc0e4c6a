#include "start_checks.h"

#include "argument.h"
#include "scene.h"
#include "tm_filling.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "group.h"
#include "input.h"
#include "modify.h"
#include "pair.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

StartChecks::StartChecks(LAMMPS *lmp, const Fix &f, ParticleState &s, const Scene &sc) :
    Pointers(lmp), fix(f), state(s), scene(sc)
{
}

const Model &StartChecks::model() const { return scene.model(); }

namespace {
// lattice sum of the masses over its value on the lattice, and spacing over that of the masses: beyond the first the
// run stops, beyond the second it warns
constexpr double DENSE = 1.17, DENSE_WARNED = 1.1, THIN = 1.09, THIN_WARNED = 1.045;
// an even lattice: scatter of the sums, particles with neighbors all around; spacing off by
constexpr double EVEN = 0.01, EVEN_LEAST = 20.0, SPACING_WARNED = 0.015;
constexpr double DENSE_OF_SIZES = 1.6, THIN_OF_SIZES = 1.4;    // where particles have sizes of their own
constexpr double CLOSE = 0.1;                                  // of the spacing: in one place
constexpr double BODIES_WARNED = 0.1, BODIES_STOPPED = 0.6;    // deeper than at the end of the last run, in spacings
constexpr double BODIES_SEEN = 0.005,
                 SPRINGS_WARNED = 0.01;       // at the first start: deeper, with more than of the motion
constexpr double CLOSE_BETWEEN_RUNS = 0.7;    // where it was not so at the end of the last run
}    // namespace

/* ---------------------------------------------------------------------- other fixes and commands */

void StartChecks::check_company(const Pair *pair)
{
  if (utils::strmatch(update->integrate_style, "^respa"))
    error->all(FLERR, "Fix sph/tm does not work with run_style respa; use run_style verlet");
  if (update->whichflag == 2)
    error->all(FLERR, "Fix sph/tm does not work with minimize: the forces follow from the history of the "
                      "deformation, not from an energy; use run, with fix sph/tm/relax to bring a body to rest");
  if (input->command && strcmp(input->command, "rerun") == 0)
    error->all(FLERR, "Fix sph/tm does not work with rerun: a dump has positions, not the state (stress, density, "
                      "temperature) that the forces follow from; write the values with the dump, or restart files");
  if (!force->pair->compute_flag || !pair->compute_flag)
    error->all(FLERR, "Fix sph/tm needs the forces of pair style sph/tm, which 'pair_modify compute no' leaves out; "
                      "write 'pair_modify compute yes'");
  for (const auto &f : modify->get_fix_by_style("^dt/reset"))
    error->all(FLERR,
               "Fix {} dt/reset works against fix sph/tm, which sets the time step itself; remove it, and limit "
               "the step with the keyword dt/max",
               f->id);
  for (const auto &f : modify->get_fix_list()) {
    if (utils::strmatch(f->style, "^press/"))
      error->all(FLERR,
                 "Fix {} {} does not work with fix sph/tm: it scales box and positions, of which stress and density "
                 "know nothing; press with a tool (fix contact/tri) or with fix sph/tm/drive",
                 f->id, f->style);
    if (f->box_change & (Fix::BOX_CHANGE_SIZE | Fix::BOX_CHANGE_SHAPE) && comm->me == 0)
      error->warning(FLERR,
                     "Fix {} {} changes the box: where it moves the particles with it, their stress and density know "
                     "nothing of it",
                     f->id, f->style);
    const auto begins = [&f](const char *style) { return utils::strmatch(f->style, style); };
    if ((begins("^langevin") || begins("^temp/") || begins("^gl[de]") || begins("^ttm")) && comm->me == 0)
      error->warning(FLERR,
                     "Fix {} {} takes the velocities of particles for those of atoms: it brakes and shakes bodies, and "
                     "knows nothing of the temperature of the metal; that is set by 'temperature' of fix sph/tm and of "
                     "fix_modify, and fix sph/tm/relax brings a body to rest",
                     f->id, f->style);
  }
  state.atoms().to_host();
  check_integrators();
  const bigint members = group->count(fix.igroup);
  if (atom->natoms == 0 && comm->me == 0)
    error->warning(FLERR, "Fix sph/tm {}: there are no particles; does create_atoms meet the region, in its units?",
                   state.id());
  bigint mine[2] = {0, 0}, solids[2];
  for (int i = 0; i < atom->nlocal; i++) {
    if (model().materials()[atom->type[i]].body != TM_BODY_SOLID) continue;
    mine[0]++;
    mine[1] += (atom->mask[i] & fix.groupbit) != 0;
  }
  MPI_Allreduce(mine, solids, 2, MPI_LMP_BIGINT, MPI_SUM, world);
  if (solids[1] && solids[1] < solids[0] && comm->me == 0)
    utils::logmesg(lmp, "sph/tm: fix {} moves {} of {} particles of metal; the others stand still\n", state.id(),
                   solids[1], solids[0]);
  if (members == 0 && atom->natoms > 0 && comm->me == 0)
    error->warning(FLERR, "Fix sph/tm {}: group {} is empty: no particle moves", state.id(), group->names[fix.igroup]);
}

// a particle with two of them would move twice as far
void StartChecks::check_integrators()
{
  for (const auto &f : modify->get_fix_list()) {
    if (f == &fix || !f->time_integrate) continue;
    const bool whole_steps = utils::strmatch(f->style, "^nv") || utils::strmatch(f->style, "^np");
    bigint mine[2] = {0, 0}, all[2];
    for (int i = 0; i < atom->nlocal; i++) {
      if (!(atom->mask[i] & f->groupbit)) continue;
      if (atom->mask[i] & state.group_bit()) mine[0]++;
      else mine[1] += whole_steps && model().materials()[atom->type[i]].body == TM_BODY_SOLID;
    }
    MPI_Allreduce(mine, all, 2, MPI_LMP_BIGINT, MPI_SUM, world);
    if (all[0])
      error->all(FLERR, "Fix {} {} also integrates {} particles of group {} that fix sph/tm {} integrates; remove it",
                 f->id, f->style, all[0], group->names[fix.igroup], state.id());
    if (!all[1]) continue;
    const std::string what = fmt::format(
        "Fix {} {} integrates {} particles of pair style sph/tm outside of group {}; it is not made for forces "
        "that are taken in the middle of a step: remove it, and take them into the group of fix sph/tm {}",
        f->id, f->style, all[1], group->names[fix.igroup], state.id());
    if (group->count(fix.igroup)) error->all(FLERR, what);
    if (comm->me == 0) error->warning(FLERR, what);    // an empty group: forces alone are asked for
  }
}

/* ---------------------------------------------------------------------- particles */

// forces and velocities that are no numbers, particles in one place
void StartChecks::check_values()
{
  for (int i = 0; i < atom->nlocal; i++) {
    const double *x = atom->x[i], *v = atom->v[i], *f = atom->f[i];
    const char *what = nullptr;
    for (int k = 0; k < 3; k++) {
      if (!std::isfinite(f[k])) what = "force";
      if (!std::isfinite(v[k])) what = "velocity";
    }
    if (what)
      error->one(FLERR,
                 "Fix sph/tm: the {} of particle {} (type {}) at {:.6g} {:.6g} {:.6g} is not a finite "
                 "number at the start; its velocity is {:.6g} {:.6g} {:.6g}",
                 what, atom->tag[i], atom->type[i], x[0], x[1], x[2], v[0], v[1], v[2]);
  }
}

void StartChecks::check_overlap(const tm_nearest &c, double least)
{
  const double dp = state.has(TM_FX_SMOOTHING) ? model().smallest_spacing() : model().settings_in_use().spacing;
  if (!(c.distance < least * dp)) return;
  double **x = atom->x;
  const auto pair = std::minmax(c.i, c.j, [&](int i, int j) { return atom->tag[i] < atom->tag[j]; });
  const int i = pair.first, j = pair.second;
  error->one(FLERR,
             "Pair style sph/tm: particles {} and {} are {} at {:.6g} {:.6g} {:.6g}; {}remove one of "
             "them ('delete_atoms overlap {:.6g} all all')",
             atom->tag[i], atom->tag[j],
             c.distance == 0.0 ? "in the same place" : fmt::format("only {:.6g} of the spacing apart", c.distance / dp),
             x[i][0], x[i][1], x[i][2], c.distance < CLOSE * dp ? "" : "set bodies one spacing apart, or ", 0.5 * dp);
}

// masses against the lattice sum of what is there: of all particles, or of those that came since the last run
void StartChecks::check_filling(bool of_fresh)
{
  const Settings &set = model().settings_in_use();
  tm_filling_args a;
  a.rows = scene.rows().host_rows();
  a.rec = scene.results().host_records();
  a.kernel = set.kernel;
  a.dim = domain->dimension;
  a.h = set.h;
  if (!state.has(TM_FX_SMOOTHING)) a.rec.size = nullptr;
  const double of_lattice = tm_filling_of_lattice(set.kernel, a.dim, set.ratio, 1.0).sum;
  std::vector<tm_filling> wider;    // lattices, each wider by a hundredth
  for (double s = 1.0; s < 2.6; s += 0.01) wider.push_back(tm_filling_of_lattice(set.kernel, a.dim, set.ratio, s));
  // one that ends within the reach of the kernel is not wide, its spread is smaller
  auto as_wide = [&wider](const tm_filling &f) {
    const auto at = std::find_if(wider.begin(), wider.end(), [&f](const tm_filling &w) { return w.sum < f.sum; });
    return f.spread > 0.9 * (at == wider.end() ? wider.back() : *at).spread;
  };
  const bool sizes = state.has(TM_FX_SMOOTHING);
  const double thin_sum = tm_filling_of_lattice(set.kernel, a.dim, set.ratio, sizes ? THIN_OF_SIZES : THIN_WARNED).sum;

  Filling mine;
  for (int i = 0; i < atom->nlocal; i++) {
    if (model().materials()[atom->type[i]].body != TM_BODY_SOLID) continue;
    if (of_fresh && !std::binary_search(fresh.begin(), fresh.end(), atom->tag[i])) continue;
    const tm_filling f = tm_filling_around(i, &a);
    const double dense = f.sum / of_lattice;
    const bool thin = f.inside && f.sum < thin_sum && as_wide(f);
    mine.particles++;
    if (f.inside && as_wide(f)) {
      mine.inside++;
      mine.sum += dense;
      mine.square += dense * dense;
    }
    mine.right += f.inside && fabs(dense - 1.0) < 0.03;
    mine.off += dense > (sizes ? DENSE_OF_SIZES : DENSE_WARNED) || thin;
    if (dense > mine.densest) {
      mine.densest = dense;
      mine.dense_at = i;
    }
    if (thin && f.sum < mine.thinnest) {
      mine.thinnest = f.sum;
      mine.thin_at = i;
    }
  }
  judge_filling(mine, of_lattice, sizes);
}

// the spacing of the lattice in use where it is that
std::string StartChecks::spacing_in_words(double spacing) const
{
  const double of_lattice = Model::lattice_spacing(lmp);
  return fabs(of_lattice - spacing) < 0.02 * spacing ? fmt::format("{:.6g}' or 'spacing lattice", of_lattice)
                                                     : fmt::format("{:.3g}", spacing);
}

// an even lattice of another spacing, by less than single particles tell
void StartChecks::judge_spacing(const Filling &mine, double of_lattice)
{
  const double sums[3] = {mine.inside, mine.sum, mine.square};
  double all[3];
  MPI_Allreduce(sums, all, 3, MPI_DOUBLE, MPI_SUM, world);
  const double mean = all[1] / std::max(all[0], 1.0), spread = all[2] / std::max(all[0], 1.0) - mean * mean;
  if (all[0] < EVEN_LEAST || spread > EVEN * EVEN || comm->me) return;
  const Settings &set = model().settings_in_use();
  const double s = tm_filling_spacing(set.kernel, domain->dimension, set.ratio, mean * of_lattice);
  if (fabs(s - 1.0) < SPACING_WARNED) return;
  error->warning(
      FLERR,
      "Pair style sph/tm: particles are {:.4g} of the spacing {:.6g} apart, so bodies have {:.3g} times the mass "
      "of their volume; write 'spacing {}' in pair_style",
      s, set.spacing, pow(s, -domain->dimension), spacing_in_words(s * set.spacing));
}

void StartChecks::judge_filling(const Filling &mine, double of_lattice, bool sizes)
{
  const Settings &set = model().settings_in_use();
  const double low[2] = {-mine.densest, mine.thinnest};
  double worst[2], count[3] = {mine.particles, mine.off, mine.right}, all[3];
  MPI_Allreduce(low, worst, 2, MPI_DOUBLE, MPI_MIN, world);
  MPI_Allreduce(count, all, 3, MPI_DOUBLE, MPI_SUM, world);
  const bool dense = -worst[0] > (sizes ? DENSE_OF_SIZES : DENSE_WARNED);
  if (!dense && worst[1] >= 1e300) return sizes ? void() : judge_spacing(mine, of_lattice);
  const double sum = dense ? -worst[0] * of_lattice : worst[1];
  const double s = tm_filling_spacing(set.kernel, domain->dimension, set.ratio, sum);
  const bool stop = dense ? -worst[0] > (sizes ? DENSE_OF_SIZES : DENSE) : s > (sizes ? THIN_OF_SIZES : THIN);

  // who has it says it
  int i = dense ? mine.dense_at : mine.thin_at;
  if (dense ? mine.densest < -worst[0] : mine.thinnest > worst[1]) i = -1;
  int rank = i >= 0 ? comm->me : comm->nprocs, first;
  MPI_Allreduce(&rank, &first, 1, MPI_INT, MPI_MIN, world);
  if (first == comm->me) {
    const double *x = atom->x[i];
    const tm_real *r = scene.results().host_records().main + tm_record(i, TM_REC);
    const double mass = r[tm_part(TM_REC_M)], due = r[tm_part(TM_REC_RHO)] * pow(set.spacing, domain->dimension);
    const std::string remedy =
        !sizes && fabs(mass / due - 1.0) > 0.05
            ? fmt::format("its mass is {:.6g}, density times spacing gives {:.6g}: leave out the mass "
                          "command, or 'set type {} "
                          "mass {:.6g}' where particles have masses of their own",
                          mass, due, atom->type[i], due)
        : all[1] > 0.3 * all[0] && all[2] < 0.05 * all[0]
            ? fmt::format("write 'spacing {}' in pair_style{}", spacing_in_words(s * set.spacing),
                          dense ? ", or delete what was created twice" : "")
        : dense ? std::string("two bodies or lattices are too close together or lie over each "
                              "other: set them one spacing "
                              "apart, or remove what is double with delete_atoms overlap")
                : std::string("a part of the particles is further apart than the spacing: create "
                              "them all on one lattice");
    const std::string text =
        fmt::format("Pair style sph/tm: particle {} (type {}) at {:.6g} {:.6g} {:.6g} has {:.3g} "
                    "times the mass around it that its "
                    "density says, as if the particles were {:.3g} of the spacing {:.6g} apart; so "
                    "have {:.0f} of {:.0f} particles, by "
                    "5 % of the spacing or more; {}",
                    atom->tag[i], atom->type[i], x[0], x[1], x[2], sum / of_lattice, s, set.spacing, all[1], all[0],
                    remedy);
    if (stop) error->one(FLERR, text);
    error->warning(FLERR, text);
  }
  if (stop) MPI_Barrier(world);
}

// degrees Celsius, most likely
void StartChecks::check_temperature() const
{
  for (int t = 1; t <= atom->ntypes; t++)
    if (tm_strength_flow(model().materials()[t].strength) == TM_FLOW_THERMAL || state.has(TM_FX_HEAT))
      return warn_of_celsius(lmp, fmt::format("Fix sph/tm {}: temperature at which particles begin", state.id()),
                             state.start_temperatures().of_all());
}

// bodies of particles in each other, more than they were at the end of the last run; in a first run also where their springs
// hold much beside the energy of the motion
void StartChecks::check_bodies(double before, bool first)
{
  double depth = state.energy().deepest_of_bodies();
  MPI_Allreduce(MPI_IN_PLACE, &depth, 1, MPI_DOUBLE, MPI_MAX, world);
  if (!(depth > before + (first ? BODIES_SEEN : BODIES_WARNED))) return;
  double mine[3] = {state.energy().spring() / model().units().energy, 0.0, 0.0}, all[3];
  for (int i = 0; i < atom->nlocal; i++) {
    const double m = atom->rmass ? atom->rmass[i] : atom->mass[atom->type[i]], *v = atom->v[i];
    mine[1] += 0.5 * force->mvv2e * m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    mine[2] += m;
  }
  MPI_Allreduce(mine, all, 3, MPI_DOUBLE, MPI_SUM, world);
  const double spring = all[0], kinetic = all[1];
  if (depth <= before + BODIES_WARNED && spring <= SPRINGS_WARNED * kinetic) return;
  const std::string text = fmt::format(
      "Pair style sph/tm: bodies in contact (pair_coeff I J contact) are {:.2g} spacings inside of each other; set them "
      "one spacing apart, centers of their first rows, or the mean of their spacings where these differ",
      depth);
  if (depth > before + BODIES_STOPPED) error->all(FLERR, "{}", text);
  if (comm->me == 0)
    error->warning(FLERR,
                   "{}: their springs hold an energy of {:.3g} (the motion of all particles has {:.3g}), enough to "
                   "throw them apart with up to {:.3g}",
                   text, spring, kinetic, sqrt(2.0 * spring / (force->mvv2e * all[2])));
}

// metal with a velocity that nothing moves acts on the rest as if it moved
void StartChecks::check_still()
{
  int movers = state.group_bit();
  for (const auto &f : modify->get_fix_list())
    if (f->time_integrate) movers |= f->groupbit;
  double mine[2] = {0.0, 0.0}, number, fastest;
  for (int i = 0; i < atom->nlocal; i++) {
    const double *v = atom->v[i], speed2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    if (atom->mask[i] & movers || speed2 == 0.0 || model().materials()[atom->type[i]].body != TM_BODY_SOLID) continue;
    mine[0] += 1.0;
    mine[1] = std::max(mine[1], sqrt(speed2));
  }
  MPI_Allreduce(mine, &number, 1, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(mine + 1, &fastest, 1, MPI_DOUBLE, MPI_MAX, world);
  if (number > 0.0 && comm->me == 0)
    error->warning(
        FLERR,
        "Fix sph/tm {}: {:.0f} particles outside of its group have a velocity (up to {:.4g}) and stay where they are: "
        "they act on others as if they moved; set it to 0, or take them into the group and move them with fix "
        "sph/tm/drive",
        state.id(), number, fastest);
}

void StartChecks::check_start()
{
  check_temperature();
  check_still();
  const tm_nearest c = scene.results().nearest();
  check_overlap(c, CLOSE);
  check_values();
  double mine[3] = {c.sum, c.count, c.flat}, all[3];
  MPI_Allreduce(mine, all, 3, MPI_DOUBLE, MPI_SUM, world);
  constexpr double SOME = 16.0;
  if (all[1] >= SOME && all[2] > 0.5 * all[1] && comm->me == 0)
    error->warning(
        FLERR,
        "Pair style sph/tm: {:.0f} of {:.0f} particles have all their neighbors in one row{}; across it they "
        "have no strain, and resist up to a third too much: give each direction two rows or more",
        all[2], all[1], domain->dimension == 3 ? " or layer" : "");
  bigint solids = 0;
  for (int t = 1; t <= atom->ntypes; t++) solids += model().materials()[t].body == TM_BODY_SOLID;
  if (all[1] == 0.0 && atom->natoms > 1 && solids) {
    const std::string text =
        fmt::format("Pair style sph/tm: no particle has a neighbor within reach; are the particles "
                    "{:.6g} (the keyword spacing) apart?",
                    model().settings_in_use().spacing);
    const double of_lattice = Model::lattice_spacing(lmp), off = of_lattice / model().settings_in_use().spacing;
    if (off > THIN) error->all(FLERR, "{} The lattice in use has {:.6g}: write 'spacing lattice'", text, of_lattice);
    if (comm->me == 0) error->warning(FLERR, text);
  }
  check_filling(false);
  check_bodies(0.0, true);    // after it: a spacing that is not that of the particles looks like bodies in each other
}

// a run that goes on: what came or was moved since the last one
void StartChecks::check_changes()
{
  if (last_run.types.empty()) return;
  const tm_nearest c = scene.results().nearest();
  const double dp = state.has(TM_FX_SMOOTHING) ? model().smallest_spacing() : model().settings_in_use().spacing;
  // flow of large strain draws particles as close as it likes
  const double flow = 0.85 * last_run.nearest / dp;
  check_overlap(c, std::min(CLOSE, flow));
  check_bodies(last_run.depth, false);
  check_still();
  check_values();
  check_strain(c);
  if (!fresh.empty()) check_filling(true);
  check_overlap(c, std::min(CLOSE_BETWEEN_RUNS, flow));
}

}    // namespace SPHTM_NS
