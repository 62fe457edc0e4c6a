#include "contact_report.h"

#include "friction_table.h"
#include "model.h"
#include "particle_state.h"

#include "atom.h"
#include "error.h"

using namespace LAMMPS_NS;

namespace SPHTM_NS {

// friction heat of a type
static std::string heat_in_words(const tm_contact_law &w, const tm_material &m, double T, const ContactSettings &set)
{
  const double e = tm_effusivity(tm_conductivity(&m, T), m.rho0, tm_capacity(&m, T));
  const char *why = set.share >= 0.0        ? "as given"
                    : set.effusivity >= 0.0 ? "by effusivity"
                    : set.body_type         ? "by effusivity, the tool's from its particles"
                                    : "half: the tool's material is not known, give 'material', 'effusivity' or "
                                      "'share'";
  return fmt::format(", {:.3f} of the friction heat into the particles ({})", tm_contact_share(&w, e), why);
}

// elastic contact that is softer than it need be; modulus: what takes the place of E in it, material: that of penalty
// material, half_layer: tm_contact_half_layer()
static std::string softness_in_words(const tm_material &m, double modulus, double material, double half_layer)
{
  if (tm_strength_flow(m.strength) != TM_FLOW_NONE || material < TM_SOFT_CONTACT * modulus) return "";
  return fmt::format("; gives way like {:.2g} spacings of the material: where few spacings touch, 'penalty material', "
                     "with {:.2g}, is nearer to what elastic contact is",
                     0.5 * half_layer / modulus, 0.5 * half_layer / material);
}

void report_contact_laws(LAMMPS *lmp, const std::string &id, const ContactSettings &set, const ContactLaws &laws,
                         ParticleState &state)
{
  const Model &model = state.model();
  const double T = state.start_temperatures().of_all();
  const bool heat = state.has(TM_FX_HEAT) && set.has_friction();
  for (int t = 1; t <= lmp->atom->ntypes; t++) {
    const tm_contact_law &w = laws.of(t);
    if (!w.active) continue;
    if (w.friction.n == 0 && w.friction.value > HIGH_FRICTION && w.shear == 0.0)
      lmp->error->warning(FLERR, "Fix contact/tri {}: friction {:.4g} {}", id, w.friction.value, FRICTION_HIGH);
    const std::string mu = (w.friction.n ? "by table" : fmt::format("{:.4g}", w.friction.value)) +
                           (w.shear > 0.0 ? fmt::format(", at most {:.4g} of the shear flow stress", w.shear) : "");
    const tm_material &m = model.materials()[t];
    utils::logmesg(lmp, "contact/tri {}: type {}: stiffness {:.6g}, damping {:.4g} of critical, friction {}{}{}\n", id,
                   t, w.stiffness / model.units().force, w.damping, mu, heat ? heat_in_words(w, m, T, set) : "",
                   softness_in_words(m, tool_modulus(set, model, t, set.penalty),
                                     tool_modulus(set, model, t, TM_PENALTY_MATERIAL),
                                     model.contact_modulus(t, TM_PENALTY_MATERIAL)));
  }
}

}    // namespace SPHTM_NS
