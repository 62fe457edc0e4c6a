#include "contact_laws.h"

#include "contact_settings.h"
#include "model.h"
#include "tm_contact_layer.h"
#include "tm_eos.h"
#include "tm_time_step.h"

#include <algorithm>
#include <cmath>

namespace SPHTM_NS {

static tm_contact_law make_law(const tm_material &m, const ContactSettings &set, const UnitScale &unit, double dp,
                               double modulus, bool dim3)
{
  tm_contact_law w = {};
  w.active = m.body == TM_BODY_SOLID;
  w.radius = 0.5 * dp;
  w.stiffness = tm_contact_stiffness(modulus, dp, dp, dim3);
  w.damping = set.damping;
  w.area = dim3 ? dp * dp : dp;
  w.friction = set.friction;
  w.shear = set.shear;
  w.share = set.share;
  w.tool_effusivity = set.effusivity * unit.energy;
  w.conductance = set.conductance > 0.0 ? set.conductance * unit.energy : set.conductance;
  return w;
}

bool layer_strains(const ContactSettings &set, const Model &model, int type)
{
  const tm_material &m = model.materials()[type];
  if (set.f15 || m.body != TM_BODY_SOLID) return false;
  if (set.layer != ContactSettings::LAYER_USUAL) return set.layer == ContactSettings::LAYER_STRAINS;
  return !set.approach && tm_strength_flow(m.strength) != TM_FLOW_NONE;
}

double tool_modulus(const ContactSettings &set, const Model &model, int type, double penalty)
{
  const bool elastic = model.materials()[type].strength == TM_STRENGTH_ELASTIC;
  if (layer_strains(set, model, type) && (penalty == TM_PENALTY_MATERIAL || (penalty < 0.0 && elastic)))
    return TM_LAYER_PENALTY * model.contact_modulus(type, TM_PENALTY_MATERIAL);
  return model.contact_modulus(type, penalty);
}

void ContactLaws::make(const ContactSettings &set, const Model &model, double T, int dimension)
{
  const double dp = model.settings_in_use().spacing;
  laws.assign(model.types() + 1, tm_contact_law{});
  dt_limit = heat_limit = 1e300;
  fastest = 0.0;
  for (int t = 1; t <= model.types(); t++) {
    const tm_material &m = model.materials()[t];
    tm_contact_law &w = laws[t] =
        make_law(m, set, model.units(), dp, tool_modulus(set, model, t, set.penalty), dimension == 3);
    w.layer = layer_strains(set, model, t);
    if (set.body_type) {
      const tm_material &b = model.materials()[set.body_type];
      w.tool_effusivity = tm_effusivity(tm_conductivity(&b, T), b.rho0, tm_capacity(&b, T));
      w.conductance = 0.0;    // conduction goes from particle to particle
    } else if (set.share < 0.0 && set.effusivity < 0.0) {
      w.share = 0.5;
    }
    if (!w.active) continue;
    const double conducts = model.time_scale();    // heat in the time of the process
    if (w.conductance > 0.0) w.conductance *= conducts;
    if (!set.body_type) w.tool_effusivity *= sqrt(conducts);
    const double h = m.heat ? tm_contact_conductance(&w, tm_conductivity(&m, T)) : 0.0;
    // A particle at the surface takes the heat of a step alone: that is accurate for a tenth of its time constant, and
    // goes on as it was where one evaluation of the conduction bears a longer step
    if (h > 0.0)
      heat_limit = std::min(heat_limit,
                            std::max(0.1 * m.rho0 * tm_capacity(&m, T) * dp / h,
                                     tm_conduction_time_step(&m, m.rho0, T, model.settings_in_use().h,
                                                             model.largest_conductivity(), model.fastest_heat_rate())));
    fastest = std::max(fastest, tm_eos_sound_speed(&m, m.rho0, 0.0));
    // with a layer the force acts on the next rows too
    const double mass = m.rho0 * pow(dp, dimension) / (w.layer ? TM_LAYER_MOBILITY : 1.0);
    // 0.35: stability of the half-step prediction, 0.78 without and 0.70 with damping, of 2
    dt_limit = std::min(dt_limit, 0.35 * tm_contact_time_step(w.stiffness, mass, w.damping));
    if (w.layer && w.damping > 0.0)
      dt_limit = std::min(dt_limit, TM_LAYER_DAMPED * m.rho0 * pow(dp, dimension) /
                                        tm_contact_damping(w.damping, w.stiffness, m.rho0 * pow(dp, dimension)));
  }
  loop_laws.assign(laws.data(), laws.size());
}

}    // namespace SPHTM_NS
