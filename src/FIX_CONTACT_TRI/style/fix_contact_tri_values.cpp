/* SPH-TM: what fix contact/tri shows and keeps: forces on the tool, restart, memory. */
#include "fix_contact_tri.h"

#include "fix_sph_tm.h"
#include "pair_sph_tm.h"
#include "restart_block.h"

#include "comm.h"
#include "error.h"
#include "update.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

/* ---------------------------------------------------------------------- values */

FixSPHTM *FixContactTri::current_state() const
{
  return FixSPHTM::current(lmp, state, fmt::format("Fix contact/tri {}", id));
}

void FixContactTri::sum_up()
{
  current_state();
  if (totals_step == update->ntimestep) return;
  totals_step = update->ntimestep;
  finish_contact();
  const double force = 1.0 / pair->units().force, power = 1.0 / pair->units().energy;
  const double mine[10] = {force * sums.force.x,        force * sums.force.y,
                           force * sums.force.z,        force * sums.torque.x,
                           force * sums.torque.y,       force * sums.torque.z,
                           power * sums.friction_power, power * sums.heat_tool,
                           (double) sums.contacts,      0.0};
  double all[10], depth;
  MPI_Allreduce(mine, all, 10, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(&sums.depth, &depth, 1, MPI_DOUBLE, MPI_MAX, world);
  std::copy_n(all, 6, totals);
  std::copy_n(all + 6, 3, totals + 9);
  totals[12] = depth / pair->settings_in_use().spacing;
}

double FixContactTri::compute_vector(int n)
{
  if (n >= 6 && n < 9) {
    const tm_pose p = pose_now();
    const tm_vec3 r = tm_pose_to_world(&p, reference_local);
    return n == 6 ? r.x : n == 7 ? r.y : r.z;
  }
  sum_up();
  return totals[n];
}

double FixContactTri::compute_scalar()
{
  if (temperature == 0.0) current_state();
  return temperature;
}

void FixContactTri::tool_force(double *force)
{
  sum_up();
  std::copy_n(totals, 3, force);
}

void *FixContactTri::extract(const char *name, int &dim)
{
  dim = 0;
  return strcmp(name, ContactProbe::NAME) == 0 ? (ContactProbe *) this : nullptr;
}

/* ---------------------------------------------------------------------- restart */

// keywords of contact and heat, whose values a restart file knows by their hash
static const char *const COMPARED[] = {"friction", "friction/shear", "penalty", "damping", "approach", "method",
                                       "sides", "heat", "share", "effusivity", "particles", "reference",
                                       "temperature", "lumped"};
static constexpr int COMPARED_SIZE = sizeof(COMPARED) / sizeof(COMPARED[0]), COMPARED_HEAT = 12;

std::vector<uint64_t> FixContactTri::keyword_hashes() const
{
  const Request &r = request;
  std::vector<double> mu = {r.friction.value, (double) r.friction.n};
  mu.insert(mu.end(), r.friction.t, r.friction.t + r.friction.n);
  mu.insert(mu.end(), r.friction.y, r.friction.y + r.friction.n);
  const bool lumped = r.lumped_capacity > 0.0;
  const uint64_t variable = hash_bytes(temperature_variable.data(), temperature_variable.size());
  const std::vector<double> values[COMPARED_SIZE] = {
      mu, {r.shear}, {r.penalty}, {r.damping}, {(double) r.approach}, {(double) r.f15}, {(double) r.two_sided},
      {r.conductance}, {r.share}, {r.effusivity}, {(double) r.body_type},
      {(double) r.reference_given, r.reference[0], r.reference[1], r.reference[2]},
      {lumped ? 0.0 : r.temperature, (double) variable}, {r.lumped_capacity, lumped ? r.temperature : 0.0}};
  std::vector<uint64_t> hashes;
  for (const auto &v : values) hashes.push_back(hash_bytes(v.data(), v.size() * sizeof(double)));
  return hashes;
}

// clock, temperature; hashes: of the file, of its placement, of the keywords; motion
static constexpr int HASHES_AT = 2, MOTION_AT = HASHES_AT + 2 * (2 + COMPARED_SIZE);

void FixContactTri::write_restart(FILE *fp)
{
  if (comm->me) return;
  std::vector<double> v = {clock, temperature};
  append_bits(v, tool.content());
  append_bits(v, shape.hash());
  for (const uint64_t h : keyword_hashes()) append_bits(v, h);
  const std::vector<double> m = motion.pack();
  v.insert(v.end(), m.begin(), m.end());
  write_restart_block(fp, v);
}

void FixContactTri::restart(char *buf)
{
  const std::string who = fmt::format("Fix contact/tri {}", id);
  constexpr size_t size = MOTION_AT + ToolMotion::PACKED;
  const std::vector<double> v = read_restart_block(lmp, who, buf, size, size);
  if (!(v[0] >= 0.0) || !(v[1] >= 0.0) || !motion.unpack(&v[MOTION_AT]))
    error->all(FLERR, "{}: the {} is damaged: it holds a motion or temperature of the tool that cannot be", who,
               restart_file_name(lmp));
  clock = v[0];
  warn_of_other_input(v);
  if (v[1] > 0.0) {
    temperature = v[1];
    temperature_given = true;
  }
  restored = seen = true;
  note_corners(pose_now(), last_corner);
}

// a tool that is not the one of the restart file goes on, but not silently
void FixContactTri::warn_of_other_input(const std::vector<double> &written)
{
  if (comm->me) return;
  const double *hash = &written[HASHES_AT];
  const std::string file = restart_file_name(lmp);
  if (take_bits(hash) != tool.content())
    error->warning(FLERR, "Fix contact/tri {}: the content of mesh file {} is not what it was when the {} was written",
                   id, shape.file, file);
  if (take_bits(hash + 2) != shape.hash())
    error->warning(FLERR, "Fix contact/tri {}: the placement of mesh file {} (scale, move, rotate, flip, merge, "
                          "smooth) is not what it was when the {} was written", id, shape.file, file);
  const std::vector<uint64_t> now = keyword_hashes();
  std::string other, heat;
  for (int k = 0; k < COMPARED_SIZE; k++) {
    if (take_bits(hash + 4 + 2 * k) == now[k]) continue;
    std::string &list = k < COMPARED_HEAT ? other : heat;
    list += (list.empty() ? "" : ", ") + std::string(COMPARED[k]);
  }
  if (!other.empty())
    error->warning(FLERR, "Fix contact/tri {}: the {} was written with other values of {}; those of the script hold",
                   id, file, other);
  if (!heat.empty())
    error->warning(FLERR, "Fix contact/tri {}: the {} was written with other values of {}; the tool goes on with {}",
                   id, file, heat, temperature_variable.empty() && written[1] > 0.0 ?
                   fmt::format("its temperature there, {:.6g}", written[1]) : "those of the script");
}

double FixContactTri::memory_usage()
{
  return tool.bytes() + (double) (tool_heat.bytes() + tri_force.bytes() + tri_heat.bytes());
}
