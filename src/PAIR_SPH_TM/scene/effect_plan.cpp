#include "effect_plan.h"

#include "body_contact_laws.h"

#include "model.h"

#include "fmt/format.h"

#include <map>

namespace SPHTM_NS {

namespace {
struct Name {
  const char *name;
  unsigned bit;
};
const Name NAMES[] = {{"viscosity", TM_FX_VISCOSITY},
                      {"artstress", TM_FX_ARTSTRESS},
                      {"heat", TM_FX_HEAT},
                      {"conduction", TM_FX_CONDUCTION},
                      {"plasticity", TM_FX_PLASTICITY},
                      {"damage", TM_FX_DAMAGE},
                      {"correction", TM_FX_CORRECTION},
                      {"faces", TM_FX_FACES},
                      {"balsara", TM_FX_BALSARA},
                      {"xsph", TM_FX_XSPH},
                      {"surface", TM_FX_SURFACE},
                      {"internal-energy", TM_FX_ENERGY},
                      {"bodies", TM_FX_BODIES},
                      {"energy", TM_FX_LEDGER},
                      {"smoothing", TM_FX_SMOOTHING},
                      {"hourglass", TM_FX_HOURGLASS},
                      {"fracture", TM_FX_FRACTURE},
                      {"contact-layer", TM_FX_LAYER},
                      {"shifting", unsigned(TM_FX_SHIFTING)},
                      {"expansion", TM_FX_EXPANSION},
                      {"compression-heat", TM_FX_COMPRESSION_HEAT},
                      {"artificial-heat", TM_FX_ARTIFICIAL_HEAT}};
}    // namespace

unsigned effect_by_name(const std::string &name)
{
  for (const auto &n : NAMES)
    if (name == n.name) return n.bit;
  return 0;
}

std::string effect_name(unsigned bits)
{
  for (const auto &n : NAMES)
    if (bits & n.bit) return n.name;
  return "";
}

std::string effect_names()
{
  std::string all;
  for (const auto &n : NAMES) all += (all.empty() ? "" : ", ") + std::string(n.name);
  return all;
}

const std::vector<unsigned> &effects_by_name()
{
  static const std::vector<unsigned> bits = [] {
    std::vector<unsigned> all;
    for (const auto &n : NAMES) all.push_back(n.bit);
    return all;
  }();
  return bits;
}

// the others have loops of their own
const std::vector<unsigned> &effects_in_loops()
{
  static const std::vector<unsigned> bits = [] {
    std::vector<unsigned> some;
    for (const auto &n : NAMES)
      if (n.bit != TM_FX_BODIES && n.bit != TM_FX_HOURGLASS && n.bit != TM_FX_FRACTURE && n.bit != TM_FX_LAYER)
        some.push_back(n.bit);
    return some;
  }();
  return bits;
}

// --- what calls for effects -------------------------------------------------------------------

namespace {
// why effects are on; the first reason counts
struct Reasons {
  const Model &model;
  std::map<unsigned, std::string> why;
  bool every_pair_stored;
  bool mechanics = false, solid = false, flows = false, softens = false, shock = false;
  bool lasting = false;        // a material in which ringing behind a shock leaves something behind
  std::string shocked = {};    // the first of them that flows, or has a shock equation of state
  std::string why_no_faces = {}, why_no_shifting = {}, why_no_heat = {};
  std::string conducts = {}, expands = {}, compresses = {};    // the first material that does, or heats by compression

  void on(unsigned bit, const std::string &reason) { why.emplace(bit, reason); }
  bool has(unsigned bit) const { return why.count(bit) > 0; }
  std::string of_type(int t) const { return "type " + std::to_string(t) + " (" + model.material_name(t) + ")"; }
  void materials();
  void contacts();
  void faces();
  void shifting(bool one_pass);
  void settings();
  void shocks();
  void conversions();
};

void Reasons::materials()
{
  for (int t = 1; t <= model.types(); t++) {
    const tm_material &m = model.materials()[t];
    if (m.body == TM_BODY_HEAT) on(TM_FX_HEAT, of_type(t) + " only conducts heat (body heat)");
    if (m.heat && (m.conductivity.n || m.conductivity.value > 0.0) && conducts.empty())
      conducts = of_type(t) + " has a conductivity";
    if (m.body != TM_BODY_SOLID) continue;
    mechanics = true;
    solid = solid || m.strength != TM_STRENGTH_NONE;
    lasting = lasting || m.strength != TM_STRENGTH_ELASTIC;
    const int flow = tm_strength_flow(m.strength);
    flows = flows || flow != TM_FLOW_NONE;
    if (flow != TM_FLOW_NONE) on(TM_FX_PLASTICITY, of_type(t) + " yields");
    if (flow != TM_FLOW_NONE && shocked.empty()) shocked = of_type(t) + " yields";
    if (m.heat && m.taylor_quinney > 0.0 && flow != TM_FLOW_NONE)
      on(TM_FX_HEAT, of_type(t) + (flow == TM_FLOW_THERMAL ? " heats by plastic work and softens with temperature"
                                                           : " heats by plastic work"));
    if (!m.heat && flow != TM_FLOW_NONE && why_no_heat.empty())
      why_no_heat = of_type(t) + " flows, but has no heat constants: it does not warm up";
    softens = softens || flow == TM_FLOW_THERMAL;
    if (m.damage != TM_DAMAGE_NONE) on(TM_FX_DAMAGE, of_type(t) + " has a damage law");
    if (m.eos == TM_EOS_SHOCK) {
      on(TM_FX_ENERGY, of_type(t) + " has a shock equation of state");
      shock = true;
      if (shocked.empty() && m.strength != TM_STRENGTH_ELASTIC) shocked = of_type(t) + " has a shock equation of state";
      if (m.eos_gamma > 0.0 && compresses.empty()) compresses = of_type(t) + " has a shock equation of state";
    } else if (m.expansion.n || m.expansion.value > 0.0) {
      if (expands.empty()) expands = of_type(t) + " has a thermal expansion";
    }
  }
}

// shocks heat, where all materials have heat constants
void Reasons::shocks()
{
  for (int t = 1; t <= model.types(); t++)
    if (!model.materials()[t].heat) return;
  if (!compresses.empty()) on(TM_FX_HEAT, compresses + " and heats by compression");
}

// what changes temperatures, or follows from them, where they are a state
void Reasons::conversions()
{
  const Settings &set = model.settings_in_use();
  if (!has(TM_FX_HEAT)) return;
  if (!expands.empty()) on(TM_FX_EXPANSION, expands);
  const std::string of = compresses.empty() ? expands : compresses;
  if (!of.empty()) on(TM_FX_COMPRESSION_HEAT, of);
  if (!has(TM_FX_VISCOSITY)) return;
  if (shock) on(TM_FX_ARTIFICIAL_HEAT, "shocks dissipate by viscosity");
  else if (set.art_eps <= 0.0) on(TM_FX_ARTIFICIAL_HEAT, "viscosity dissipates");
}

// friction and conduction between bodies, where all materials have heat constants
void Reasons::contacts()
{
  for (int t = 1; t <= model.types(); t++)
    if (!model.materials()[t].heat) return;
  for (int i = 1; i <= model.types(); i++)
    for (int j = i + 1; j <= model.types(); j++) {
      const PairLaw &l = model.pair_laws()(i, j);
      if (l.meeting != CONTACT || !(l.has_friction() || l.conductance >= 0.0)) continue;
      on(TM_FX_HEAT,
         "contact of " + of_type(i) + " and " + of_type(j) + (l.has_friction() ? " has friction" : " conducts heat"));
    }
}

void Reasons::settings()
{
  const Settings &set = model.settings_in_use();
  const bool monaghan = set.visc_alpha > 0.0 || set.visc_beta > 0.0;
  if (monaghan && mechanics) on(TM_FX_VISCOSITY, "pair_style viscosity is not 0");
  if (set.art_eps > 0.0 && solid) on(TM_FX_ARTSTRESS, "pair_style artstress is not 0");
  if (set.correction && mechanics) on(TM_FX_CORRECTION, "pair_style correction yes");
  if (set.balsara) on(TM_FX_BALSARA, "pair_style balsara yes");
  if (set.hourglass != 0.0 && mechanics && !(every_pair_stored && set.hourglass < 0.0))
    on(TM_FX_HOURGLASS, "pair_style hourglass is not 0");
  if (solid) on(TM_FX_FRACTURE, "particles that lose neighbors without damage are counted");
  if (set.xsph > 0.0) on(TM_FX_XSPH, "pair_style xsph is not 0");
  if (model.pair_laws().has_contact()) on(TM_FX_BODIES, "pair_coeff contact");
  for (int i = 1; i <= model.types(); i++)
    for (int j = 1; j <= model.types(); j++)
      if (layer_strains(model, i, model.pair_laws()(i, j)))
        on(TM_FX_LAYER, "contact of " + of_type(std::min(i, j)) + " and " + of_type(std::max(i, j)));
}
// second order at free faces: behind what the script forces, since it depends on what flows
void Reasons::faces()
{
  const Settings &set = model.settings_in_use();
  if (!solid || !has(TM_FX_CORRECTION) || !has(TM_FX_HOURGLASS) || has(TM_FX_ARTSTRESS)) return;
  const bool flowing = flows && has(TM_FX_PLASTICITY);
  if (set.faces == FACES_ALWAYS) on(TM_FX_FACES, "pair_style correction second");
  if (set.faces == FACES_OF_ELASTIC && !flowing) on(TM_FX_FACES, "no material flows");
  if (set.faces == FACES_OF_ELASTIC && flowing)
    why_no_faces = "material can flow; thin parts bend too softly, pair_style correction second mends that";
  if (set.faces == FACES_NEVER) why_no_faces = "pair_style correction linear";
}

// of updated-Lagrangian pairs: those that are kept know where they were
void Reasons::shifting(bool one_pass)
{
  if (!flows || !has(TM_FX_PLASTICITY)) return;
  if (!one_pass)
    why_no_shifting = "needs gradient correction and hourglass control in one pass, and no lists that keep pairs";
  else on(unsigned(TM_FX_SHIFTING), "material flows");
}
}    // namespace

// --- the plan ---------------------------------------------------------------------------------

bool EffectPlan::ask(unsigned effect, const std::string &reason)
{
  if ((asked_for & effect) == effect) return false;
  asked_for |= effect;
  asked.push_back({effect, reason});
  return true;
}

void EffectPlan::derive(const Model &model, int dimension)
{
  const Settings &set = model.settings_in_use();
  Reasons r{model, {}, every_pair_stored};
  r.materials();
  r.contacts();
  r.shocks();
  for (const auto &a : asked) r.on(a.first, a.second);
  r.settings();
  for (const auto &n : NAMES)
    if (forced_on & n.bit) r.on(n.bit, "asked for in fix sph/tm");
  warn(r.why, r.softens);

  for (const auto &n : NAMES)
    if (forced_off & n.bit) r.why.erase(n.bit);
  r.faces();
  std::string why_no_faces = r.why_no_faces;
  if (forced_off & TM_FX_FACES) r.why.erase(TM_FX_FACES);
  r.conversions();
  for (const auto &n : NAMES)
    if (forced_off & n.bit) r.why.erase(n.bit);
  if (r.has(TM_FX_HEAT) && !r.conducts.empty() && !(forced_off & TM_FX_CONDUCTION)) r.on(TM_FX_CONDUCTION, r.conducts);

  // forced on, but what it acts on is off
  contradiction.clear();
  if ((forced_on & TM_FX_BALSARA) && !r.has(TM_FX_VISCOSITY))
    contradiction = "balsara is forced on, but there is no viscosity for it to switch";
  if (r.has(TM_FX_CORRECTION) && set.form_f14) contradiction = "correction needs pair_style form f15";
  const unsigned of_heat[] = {TM_FX_CONDUCTION, TM_FX_EXPANSION, TM_FX_COMPRESSION_HEAT, TM_FX_ARTIFICIAL_HEAT};
  for (const unsigned bit : of_heat) {
    if (r.has(TM_FX_HEAT)) break;
    if ((forced_on & bit) && contradiction.empty())
      contradiction = effect_name(bit) + " is forced on, but heat is off; add 'effects heat on' and heat constants";
    r.why.erase(bit);
  }
  if (!r.has(TM_FX_VISCOSITY)) r.why.erase(TM_FX_BALSARA);
  heat_reason = r.has(TM_FX_HEAT) ? r.why[TM_FX_HEAT] : "";

  const bool one_pass =
      r.has(TM_FX_CORRECTION) && r.has(TM_FX_HOURGLASS) && !r.has(TM_FX_ARTSTRESS) && !separate_passes;
  r.why.erase(unsigned(TM_FX_SHIFTING));
  r.shifting(one_pass);
  if ((forced_on & TM_FX_SHIFTING) && !r.has(unsigned(TM_FX_SHIFTING)))
    contradiction =
        "shifting needs a material that flows, gradient correction and hourglass control in one pass, and no "
        "lists of fix adapt/neigh that keep pairs";
  if (forced_off & TM_FX_SHIFTING) r.why.erase(unsigned(TM_FX_SHIFTING));

  effects = (dimension == 3 ? unsigned(TM_FX_3D) : 0u) | ((unsigned) set.kernel << TM_FX_KERNEL_SHIFT);
  if (set.form_f14) effects |= TM_FX_FORM_F14;
  if (set.plane_stress) effects |= TM_FX_PLANE_STRESS;
  if (set.mixed) effects |= TM_FX_MIXED;
  for (const auto &w : r.why) effects |= w.first;
  if (one_pass) effects |= TM_FX_ONE_PASS;
  if ((effects & TM_FX_FACES) && !(effects & TM_FX_ONE_PASS)) {
    if (forced_on & TM_FX_FACES)
      contradiction =
          "faces needs gradient correction and hourglass control in one pass: no artificial stress, and no lists "
          "of fix adapt/neigh that keep pairs";
    effects &= ~unsigned(TM_FX_FACES);
    r.why.erase(TM_FX_FACES);
    why_no_faces = "lists keep pairs; thin parts bend too softly";
  }
  write_report(r.why, {{TM_FX_HEAT, r.why_no_heat},
                       {TM_FX_FACES, why_no_faces},
                       {unsigned(TM_FX_SHIFTING), r.why_no_shifting},
                       {TM_FX_EXPANSION, r.expands.empty() ? "" : "heat is off: nothing changes temperatures"}});
  bulk_viscosity(model, r.shocked, r.lasting);
}

// of shocks: behind the effects, since it needs one pass
void EffectPlan::bulk_viscosity(const Model &model, const std::string &shocked, bool lasting)
{
  constexpr double USUAL = 0.5;    // wide enough that little rings behind a front, narrow enough for plates of few rows
  const double given = model.settings_in_use().shock;
  std::string why_not;
  if (!lasting) why_not = "no material flows";
  else if (effects & TM_FX_PLANE_STRESS) why_not = "there is none in plane stress";
  else if (separate_passes) why_not = "lists of fix adapt/neigh keep pairs";
  else if (!(effects & TM_FX_CORRECTION)) why_not = "it needs gradient correction";
  else if (!(effects & TM_FX_HOURGLASS)) why_not = "it needs hourglass control";
  else if (effects & TM_FX_ARTSTRESS) why_not = "there is artificial stress";
  else if (effects & TM_FX_FACES) why_not = "faces are of second order";

  shock = !why_not.empty() ? 0.0 : given >= 0.0 ? given : shocked.empty() || !no_shock.empty() ? 0.0 : USUAL;
  if (given > 0.0 && !why_not.empty()) warnings.push_back("Pair style sph/tm shock has no effect: " + why_not);
  if (!lasting) return;
  std::string line = fmt::format("sph/tm shock {:g}", shock);
  line.resize(32, ' ');
  if (!why_not.empty()) line += why_not;
  else if (given >= 0.0) line += "asked for in pair_style";
  else if (!no_shock.empty()) line += no_shock;
  else if (shocked.empty()) line += "no material yields or has a shock equation of state";
  else line += shocked;
  report.push_back(line);
}

// forced off, but a material or a fix has a use for it
void EffectPlan::warn(const std::map<unsigned, std::string> &why, bool softens)
{
  const unsigned needed = unsigned(TM_FX_HEAT) | TM_FX_PLASTICITY | TM_FX_DAMAGE | TM_FX_ENERGY | TM_FX_BODIES;
  warnings.clear();
  for (const auto &n : NAMES)
    if ((forced_off & needed & n.bit) && why.count(n.bit))
      warnings.push_back(std::string("Fix sph/tm: ") + n.name + " is forced off, but " + why.at(n.bit));
  if (softens && !why.count(TM_FX_HEAT))
    warnings.push_back("Fix sph/tm: softening by temperature needs heat constants (pair_coeff heat); the "
                       "temperature stays uniform");
}

void EffectPlan::write_report(const std::map<unsigned, std::string> &why,
                              const std::map<unsigned, std::string> &why_not)
{
  report.clear();
  for (const auto &n : NAMES) {
    const auto it = why.find(n.bit);
    std::string line = "sph/tm effect " + std::string(n.name);
    line.resize(32, ' ');
    if (it != why.end()) line += "on   " + it->second;
    else if (forced_off & n.bit) line += "off  forced off in fix sph/tm";
    else if (why_not.count(n.bit) && !why_not.at(n.bit).empty()) line += "off  " + why_not.at(n.bit);
    else line += "off  nothing in the scene calls for it";
    report.push_back(line);
  }
}

}    // namespace SPHTM_NS
