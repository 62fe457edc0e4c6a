#include "unit_scale.h"

#include "material_constants.h"

#include "domain.h"
#include "force.h"
#include "lammps.h"

namespace SPHTM_NS {

UnitScale unit_scale(LAMMPS_NS::LAMMPS *lmp)
{
  const LAMMPS_NS::Force *f = lmp->force;
  UnitScale u;
  u.force = f->ftm2v;
  u.energy = 1.0 / f->mvv2e;
  u.stress = f->ftm2v / f->nktv2p;
  u.density = 1.0 / f->mv2d;
  return u;
}

static void scale_table(tm_table &t, double k)
{
  t.value *= k;
  for (int i = 0; i < t.n; i++) t.y[i] *= k;
}

void scale_material(tm_material &m, const UnitScale &u)
{
  for (const Material::Constant &c : Material::constants()) {
    if (c.unit == Material::DENSITY) m.*c.number *= u.density;
    if (c.unit == Material::STRESS) m.*c.number *= u.stress;
  }
  m.shear *= u.stress;
  m.bulk *= u.stress;
  if (m.eos != TM_EOS_SHOCK) m.eos_c0 = sqrt(m.bulk / m.rho0);
  scale_table(m.conductivity, u.energy);
  scale_table(m.capacity, u.energy);
}

}    // namespace SPHTM_NS
