/* SPH-TM: the tool of fix contact/tri in restart files: clock, temperature, motion, hashes of what it was made of. */
#include "fix_contact_tri.h"

#include "restart_block.h"

#include "comm.h"
#include "error.h"

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

// clock and temperature; two numbers for each hash: of the file, of its placement, of the keywords; motion
static constexpr int HASHES_AT = 2, KEYWORDS_AT = HASHES_AT + 4;
static size_t motion_at(const ContactSettings &set) { return KEYWORDS_AT + 2 * set.hashes().size(); }

void FixContactTri::write_restart(FILE *fp)
{
  if (comm->me) return;
  std::vector<double> v = {motion.clock(), temperature.now()};
  append_bits(v, tool.content());
  append_bits(v, set.shape.hash());
  for (const auto &h : set.hashes()) append_bits(v, h.value);
  const std::vector<double> m = motion.pack();
  v.insert(v.end(), m.begin(), m.end());
  write_restart_block(fp, v);
}

void FixContactTri::restart(char *buf)
{
  const std::string who = fmt::format("Fix contact/tri {}", id);
  const size_t at = motion_at(set), size = at + ToolMotion::PACKED;
  const std::vector<double> v = read_restart_block(lmp, who, buf, size, size);
  if (!(v[0] >= 0.0) || !(v[1] >= 0.0) || !motion.unpack(v[0], &v[at]))
    error->all(FLERR, "{}: the {} is damaged: it holds a motion or temperature of the tool that cannot be", who,
               restart_file_name(lmp));
  warn_of_other_input(v);
  if (v[1] > 0.0) temperature.restore(v[1]);
  restored = true;
  checks.restarted_at(motion.pose_now());
}

// a tool that is not the one of the restart file goes on, but not silently
void FixContactTri::warn_of_other_input(const std::vector<double> &written) const
{
  if (comm->me) return;
  const double *hash = &written[HASHES_AT];
  const std::string file = restart_file_name(lmp);
  if (take_bits(hash) != tool.content())
    error->warning(FLERR, "Fix contact/tri {}: the content of mesh file {} is not what it was when the {} was written",
                   id, set.shape.file, file);
  if (take_bits(hash + 2) != set.shape.hash())
    error->warning(FLERR,
                   "Fix contact/tri {}: the placement of mesh file {} (scale, move, rotate, flip, merge, "
                   "smooth) is not what it was when the {} was written",
                   id, set.shape.file, file);
  std::string other, heat;
  hash = &written[KEYWORDS_AT];
  for (const auto &now : set.hashes()) {
    const std::string keyword = now.keyword;
    std::string &list = keyword == "temperature" || keyword == "lumped" ? heat : other;
    if (take_bits(hash) != now.value) list += (list.empty() ? "" : ", ") + keyword;
    hash += 2;
  }
  if (!other.empty())
    error->warning(FLERR, "Fix contact/tri {}: the {} was written with other values of {}; those of the script hold",
                   id, file, other);
  if (!heat.empty())
    error->warning(FLERR, "Fix contact/tri {}: the {} was written with other values of {}; the tool goes on with {}",
                   id, file, heat,
                   !temperature.by_variable() && written[1] > 0.0
                       ? fmt::format("its temperature there, {:.6g}", written[1])
                       : "those of the script");
}
