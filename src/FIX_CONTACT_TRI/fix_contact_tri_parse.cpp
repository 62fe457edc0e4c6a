/* SPH-TM: the arguments of fix contact/tri. */
#include "fix_contact_tri.h"

#include "argument.h"

#include "error.h"
#include "utils.h"

#include <cstring>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

static const char *const KEYWORDS =
    "file, scale, move, rotate, friction, friction/table, friction/shear, penalty, damping, "
    "approach, method, sides, heat, temperature, lumped, share, effusivity, particles, reference, "
    "vtk, stl, local, flip, merge, smooth, overlap";

namespace {
// values of one keyword, checked as they are read
struct Values {
  LAMMPS *lmp;
  std::string key;
  int iarg, narg;
  char **arg;

  const char *text(int k) const
  {
    if (iarg + k >= narg)
      lmp->error->all(FLERR, "Fix contact/tri keyword {} needs {} value{} or more", key, k,
                      k == 1 ? "" : "s");
    return arg[iarg + k];
  }
  double number(int k) const { return SPHTM_NS::number(lmp, "Fix contact/tri " + key, text(k)); }
  double positive(int k) const
  {
    const double x = number(k);
    if (!(x > 0.0)) lmp->error->all(FLERR, "Fix contact/tri {} must be > 0, got {}", key, text(k));
    return x;
  }
  double at_least_0(int k) const
  {
    const double x = number(k);
    if (!(x >= 0.0))
      lmp->error->all(FLERR, "Fix contact/tri {} must be >= 0, got {}", key, text(k));
    return x;
  }
  double within(int k, double lo, double hi) const
  {
    const double x = number(k);
    if (!(x >= lo && x <= hi))
      lmp->error->all(FLERR, "Fix contact/tri {} must be from {} to {}, got {}", key, lo, hi,
                      text(k));
    return x;
  }
  bool yes(int k) const { return yes_no(lmp, "Fix contact/tri " + key, text(k)); }
  // the first of two words: false, the second: true
  bool second(const char *a, const char *b) const
  {
    const char *t = text(1);
    if (strcmp(t, a) != 0 && strcmp(t, b) != 0)
      lmp->error->all(FLERR, "Fix contact/tri {} must be {} or {}, got {}", key, a, b, t);
    return strcmp(t, b) == 0;
  }
  bool more_numbers(int k) const { return iarg + k < narg && utils::is_double(arg[iarg + k]); }
};
}    // namespace

// each parser returns how many arguments it used, 0 when the keyword is not its own

int FixContactTri::parse_placement(int iarg, int narg, char **arg)
{
  const Values v{lmp, arg[iarg], iarg, narg, arg};
  TriTool::Placement p = {};
  int used = 0;
  if (v.key == "scale") {
    p.kind = TriTool::Placement::SCALE;
    const bool three = v.more_numbers(2);
    for (int k = 0; k < 3; k++) p.value[k] = v.number(three ? 1 + k : 1);
    if (p.value[0] * p.value[1] * p.value[2] == 0.0)
      error->all(FLERR, "Fix contact/tri scale must not be 0");
    used = three ? 4 : 2;
  } else if (v.key == "move") {
    p.kind = TriTool::Placement::MOVE;
    for (int k = 0; k < 3; k++) p.value[k] = v.number(1 + k);
    used = 4;
  } else if (v.key == "rotate") {
    p.kind = TriTool::Placement::ROTATE;
    if (strcmp(v.text(1), "axis") != 0 || strcmp(v.text(5), "angle") != 0)
      error->all(FLERR, "Fix contact/tri rotate must read: rotate axis ax ay az angle degrees");
    for (int k = 0; k < 3; k++) p.value[k] = v.number(2 + k);
    if (p.value[0] == 0.0 && p.value[1] == 0.0 && p.value[2] == 0.0)
      error->all(FLERR, "Fix contact/tri rotate axis must not be zero");
    p.value[3] = v.number(6);
    used = 7;
  } else if (v.key == "flip") {
    shape.flip = v.yes(1);
    return 2;
  } else if (v.key == "merge") {
    shape.options.tolerance = v.within(1, 0.0, 0.01);
    return 2;
  } else if (v.key == "smooth") {
    shape.options.smooth_angle = v.within(1, 0.0, 90.0);
    return 2;
  }
  if (used) shape.placement.push_back(p);
  return used;
}

int FixContactTri::parse_friction(int iarg, int narg, char **arg)
{
  const Values v{lmp, arg[iarg], iarg, narg, arg};
  if (v.key == "friction") {
    request.friction = {};
    request.friction.value = v.at_least_0(1);
    return 2;
  }
  if (v.key == "friction/table") {
    tm_table &t = request.friction;
    t = {};
    while (v.more_numbers(1 + 2 * t.n)) {
      if (t.n == TM_TABLE_MAX)
        error->all(FLERR, "Fix contact/tri friction/table takes at most {} pairs", TM_TABLE_MAX);
      t.t[t.n] = v.number(1 + 2 * t.n);
      t.y[t.n] = v.at_least_0(2 + 2 * t.n);
      if (t.n && t.t[t.n] <= t.t[t.n - 1])
        error->all(FLERR, "Fix contact/tri friction/table: temperatures must increase");
      t.n++;
    }
    if (t.n == 0) error->all(FLERR, "Fix contact/tri friction/table must read: T1 mu1 T2 mu2 ...");
    return 1 + 2 * t.n;
  }
  if (v.key == "friction/shear")
    request.shear = v.within(1, 0.0, 1.0);
  else if (v.key == "penalty")
    request.penalty = v.positive(1);
  else if (v.key == "damping")
    request.damping = v.at_least_0(1);
  else if (v.key == "approach")
    request.approach = v.yes(1);
  else if (v.key == "method")
    request.f15 = v.second("closest", "f15");
  else if (v.key == "sides")
    request.two_sided = v.second("one", "two");
  else if (v.key == "overlap")
    request.overlap_allowed = v.second("stop", "allow");
  else
    return 0;
  return 2;
}

int FixContactTri::parse_heat(int iarg, int narg, char **arg)
{
  const Values v{lmp, arg[iarg], iarg, narg, arg};
  if (v.key == "heat") {
    const std::string how = v.text(1);
    heat_given = how != "none";
    if (how == "none")
      request.conductance = 0.0;
    else if (how == "perfect")
      request.conductance = -1.0;
    else if (how == "conductance")
      request.conductance = v.positive(2);
    else
      error->all(FLERR, "Fix contact/tri heat must be none, perfect or conductance hc, got {}",
                 how);
    return how == "conductance" ? 3 : 2;
  }
  if (v.key == "temperature") {
    temperature_given = true;
    if (utils::strmatch(v.text(1), "^v_"))
      temperature_variable = v.text(1) + 2;
    else
      temperature = v.positive(1);
    return 2;
  }
  if (v.key == "lumped") {
    request.lumped_capacity = v.positive(1) * v.positive(2);
    temperature = v.positive(3);
    temperature_given = heat_given = true;
    return 4;
  }
  if (v.key == "share")
    request.share = v.within(1, 0.0, 1.0);
  else if (v.key == "effusivity")
    request.effusivity = v.at_least_0(1);
  else if (v.key == "particles") {
    request.body_type = utils::inumeric(FLERR, v.text(1), false, lmp);
    if (request.body_type < 1)
      error->all(FLERR, "Fix contact/tri particles must be an atom type, got {}", v.text(1));
    heat_given = true;
  } else
    return 0;
  return 2;
}

int FixContactTri::parse_output(int iarg, int narg, char **arg)
{
  const Values v{lmp, arg[iarg], iarg, narg, arg};
  if (v.key == "vtk" || v.key == "stl") {
    File &file = v.key == "vtk" ? vtk : stl;
    file.every = utils::inumeric(FLERR, v.text(1), false, lmp);
    file.name = v.text(2);
    if (file.every < 1)
      error->all(FLERR, "Fix contact/tri {}: number of steps must be > 0, got {}", v.key,
                 v.text(1));
    if (file.name.find('*') == std::string::npos)
      error->all(FLERR, "Fix contact/tri {}: file name {} needs a * for the step", v.key,
                 file.name);
    return 3;
  }
  if (v.key == "local") {
    local_every = utils::inumeric(FLERR, v.text(1), false, lmp);
    if (local_every < 1)
      error->all(FLERR, "Fix contact/tri local must be > 0 steps, got {}", v.text(1));
    local_flag = 1;
    local_freq = local_every;
    size_local_cols = 18;
    size_local_rows = 0;
    return 2;
  }
  if (v.key == "reference" || v.key == "reference_point") {
    for (int k = 0; k < 3; k++) request.reference[k] = v.number(1 + k);
    request.reference_given = true;
    return 4;
  }
  return 0;
}

void FixContactTri::parse(int narg, char **arg)
{
  for (int iarg = 3; iarg < narg;) {
    const Values v{lmp, arg[iarg], iarg, narg, arg};
    int used = 0;
    if (v.key == "file") {
      shape.file = v.text(1);
      used = 2;
    }
    if (!used) used = parse_placement(iarg, narg, arg);
    if (!used) used = parse_friction(iarg, narg, arg);
    if (!used) used = parse_heat(iarg, narg, arg);
    if (!used) used = parse_output(iarg, narg, arg);
    if (!used)
      error->all(FLERR, "Unknown fix contact/tri keyword {}: known are {}", v.key, KEYWORDS);
    iarg += used;
  }
  if (shape.file.empty())
    error->all(FLERR, "Fix contact/tri needs a mesh: fix ID group contact/tri file insert.stl ...");
  if (request.share >= 0.0 && request.effusivity >= 0.0)
    error->all(FLERR, "Fix contact/tri: give either share or effusivity, not both");
  if (request.f15 && request.two_sided)
    error->all(FLERR, "Fix contact/tri: method f15 has no sides, leave the keyword out");
  if (request.body_type && (request.conductance != 0.0 || request.lumped_capacity > 0.0))
    error->all(FLERR,
               "Fix contact/tri: with particles the tool's heat is theirs; leave out heat "
               "and lumped, and set the conductance in pair_coeff");
  if (request.lumped_capacity > 0.0 && !temperature_variable.empty())
    error->all(FLERR,
               "Fix contact/tri: a lumped tool has a temperature of its own, not a variable's");
}
