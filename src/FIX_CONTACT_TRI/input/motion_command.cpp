#include "motion_command.h"

#include "argument.h"

#include "domain.h"
#include "error.h"
#include "lammps.h"
#include "tokenizer.h"
#include "utils.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

namespace {
struct Style {
  const char *name;
  int kind, numbers;
  const char *arguments;
};
constexpr int BY_VARIABLE = -1;
const Style styles[] = {{"none", TM_MOTION_NONE, 0, ""},
                        {"linear", TM_MOTION_LINEAR, 3, "Vx Vy Vz"},
                        {"wiggle", TM_MOTION_WIGGLE, 4, "Ax Ay Az period"},
                        {"rotate", TM_MOTION_ROTATE, 7, "Px Py Pz Rx Ry Rz period"},
                        {"transrot", TM_MOTION_TRANSROT, 10, "Vx Vy Vz Px Py Pz Rx Ry Rz period"},
                        {"variable", BY_VARIABLE, 6, "v_dx v_dy v_dz v_vx v_vy v_vz"}};
}    // namespace

// numbers of a motion into its struct
static tm_motion fill(const Style &s, const double *a)
{
  tm_motion m;
  memset(&m, 0, sizeof(m));
  m.kind = s.kind == BY_VARIABLE ? (int) TM_MOTION_NONE : s.kind;
  m.period = 1.0;
  if (m.kind != TM_MOTION_ROTATE) m.v = tm_vec(a[0], a[1], a[2]);
  if (m.kind == TM_MOTION_WIGGLE) m.period = a[3];
  if (m.kind == TM_MOTION_ROTATE || m.kind == TM_MOTION_TRANSROT) {
    const double *turn = a + (m.kind == TM_MOTION_TRANSROT ? 3 : 0);
    m.point = tm_vec(turn[0], turn[1], turn[2]);
    m.axis = tm_vec(turn[3], turn[4], turn[5]);
    m.period = turn[6];
  }
  return m;
}

static void check(LAMMPS *lmp, const char *name, const tm_motion &m, bool along_z)
{
  Error *error = lmp->error;
  const bool turns = m.kind == TM_MOTION_ROTATE || m.kind == TM_MOTION_TRANSROT;
  if (turns && !(tm_vec_norm(m.axis) > 0.0))
    error->all(FLERR, "Fix contact/tri move {}: the axis Rx Ry Rz must not be zero", name);
  if (m.period == 0.0) error->all(FLERR, "Fix contact/tri move {}: the period must not be 0", name);
  if (lmp->domain->dimension == 3) return;
  if (turns && (m.axis.x != 0.0 || m.axis.y != 0.0))
    error->all(FLERR, "Fix contact/tri move {}: the axis must be along z in 2d", name);
  if (m.v.z != 0.0 || along_z)
    error->all(FLERR, "Fix contact/tri move {}: no motion along z in 2d, use 0 or NULL", name);
}

// 0, or 1 for a list of ranges such as 1,3*5 or *, which must hold the number of the tool's surface
static int words_of_surfaces(LAMMPS *lmp, int surface, const char *text)
{
  if (strspn(text, "0123456789*,") != strlen(text)) return 0;
  constexpr int MOST = 1000000000;
  for (const auto &range : Tokenizer(text, ",").as_vector()) {
    int lo, hi;
    utils::bounds(FLERR, range, 1, MOST, lo, hi, lmp->error);
    if (lo <= surface && surface <= hi) return 1;
  }
  lmp->error->all(FLERR, "Fix contact/tri move {}: the surface of this tool has the number {}", text, surface);
}

MotionCommand read_motion(LAMMPS *lmp, int surface, int narg, char **arg)
{
  Error *error = lmp->error;
  const int skipped = narg ? words_of_surfaces(lmp, surface, arg[0]) : 0;
  Keywords k(lmp, "Fix contact/tri move", narg - skipped, arg + skipped);
  if (!k.next()) utils::missing_cmd_args(FLERR, "fix_modify move of fix contact/tri", error);
  const Style *s = std::find_if(std::begin(styles), std::end(styles), [&](const Style &t) { return k.is(t.name); });
  if (s == std::end(styles))
    error->all(FLERR, "Fix contact/tri move must be linear, wiggle, rotate, transrot, variable or none, got {}",
               k.name());
  if (k.rest() < s->numbers) error->all(FLERR, "{} needs {}", k.what(), s->arguments);
  std::vector<std::string> vars;
  double a[10] = {0};
  for (int n = 0; n < s->numbers; n++) {
    const bool null = k.take("NULL");
    if (s->kind != BY_VARIABLE) {
      a[n] = null ? 0.0 : k.number();
      continue;
    }
    const char *text = null ? "v_" : k.value();
    if (strncmp(text, "v_", 2) != 0) error->all(FLERR, "{} needs v_name or NULL, got {}", k.what(), text);
    vars.emplace_back(text + 2);
  }
  tm_motion m = fill(*s, a);
  check(lmp, s->name, m, !vars.empty() && !(vars[2].empty() && vars[5].empty()));
  if (k.option({"ramp"})) {
    if (m.kind == TM_MOTION_NONE) error->all(FLERR, "Fix contact/tri move {} has no ramp", s->name);
    m.ramp = k.not_negative("(time)");
  }
  return {m, vars, narg - k.rest()};
}

}    // namespace SPHTM_NS
