#include "body_contact_laws.h"

#include "model.h"

#include "tm_contact_layer.h"
#include "tm_strength.h"

namespace SPHTM_NS {

bool layer_strains(const Model &model, int type, const PairLaw &law)
{
  const tm_material &m = model.materials()[type];
  if (law.meeting != CONTACT || m.body != TM_BODY_SOLID || law.layer == LAYER_OF_BODIES_RIGID) return false;
  return law.layer == LAYER_OF_BODIES_STRAINS || tm_strength_flow(m.strength) != TM_FLOW_NONE;
}

// with a layer that strains the spring has no compliance of the metal in it, as at tools
double contact_modulus_of_two(const Model &model, int t, int u)
{
  const PairLaw &l = model.pair_laws()(t, u);
  const auto of = [&](int type) {
    const bool elastic = model.materials()[type].strength == TM_STRENGTH_ELASTIC;
    const bool stiff = l.penalty == TM_PENALTY_MATERIAL || (l.penalty < 0.0 && elastic);
    return stiff && layer_strains(model, type, l) ? TM_LAYER_PENALTY * model.contact_modulus(type, TM_PENALTY_MATERIAL)
                                                  : model.contact_modulus(type, l.penalty);
  };
  return tm_contact_modulus_of_two(of(t), of(u));
}

}    // namespace SPHTM_NS
