#include "refine_criterion.h"

#include "argument.h"
#include "tm_output.h"

#include "atom.h"
#include "compute.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "input.h"
#include "modify.h"
#include "region.h"
#include "utils.h"
#include "variable.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

// of compute sph/tm/atom
static bool is_attribute(const std::string &name)
{
#define TM_OUTPUT_NAME(id, name) name,
  static const char *const attributes[] = {TM_OUTPUT_TABLE(TM_OUTPUT_NAME)};
#undef TM_OUTPUT_NAME
  return std::find(std::begin(attributes), std::end(attributes), name) != std::end(attributes);
}

RefineCriteria::~RefineCriteria()
{
  Modify *modify = parts.host()->modify;
  for (const Source &s : sources)
    if (!s.compute_id.empty() && modify && modify->get_compute_by_id(s.compute_id))
      modify->delete_compute(s.compute_id);
}

/* ---------------------------------------------------------------------- reading */

void RefineCriteria::read(const std::string &what, Keywords &k)
{
  bool after_or = false;
  do {
    terms.push_back(read_term(what, k));
    terms.back().after_or = after_or;
    after_or = k.take("or");
  } while (after_or || k.take("and"));
}

RefineCriteria::Term RefineCriteria::read_term(const std::string &what, Keywords &k)
{
  LAMMPS *lmp = parts.host();
  Error *error = lmp->error;
  auto next = [&](const char *expected) {
    if (!k.rest()) error->all(FLERR, "{} ends where {} is expected", what, expected);
    return k.value();
  };
  Term t;
  t.negate = k.take("not");
  std::string word = next(t.negate ? "a criterion after not" : "a criterion");
  if (word == "region") {
    t.kind = REGION;
    t.region = next("a region ID");
    if (!lmp->domain->get_region_by_id(t.region)) error->all(FLERR, "{}: there is no region {}", what, t.region);
    return t;
  }
  t.kind = word == "neighbors" ? NEIGHBORS : word == "gradient" ? GRADIENT : VALUE;
  if (t.kind == GRADIENT) word = next("a value after gradient");
  if (t.kind != NEIGHBORS) t.source = read_source(what, word);
  const std::string side = next("above or below");
  if (side != "above" && side != "below")
    error->all(FLERR, "{}: {} must be followed by above or below, got {}", what, word, side);
  t.above = side == "above";
  t.limit = number(lmp, what + " " + word + " " + side, next("a limit"));
  return t;
}

// c_ID, c_ID[n], f_ID, f_ID[n], v_name, or an attribute of compute sph/tm/atom
int RefineCriteria::read_source(const std::string &what, const std::string &text)
{
  LAMMPS *lmp = parts.host();
  Source s;
  std::string name = text;
  if (name.size() > 2 && name[1] == '_' && strchr("cfv", name[0])) {
    s.kind = name[0] == 'c' ? Source::COMPUTE : name[0] == 'f' ? Source::FIX : Source::VARIABLE;
    name = name.substr(2);
    const auto bracket = name.find('[');
    if (bracket != std::string::npos) {
      const std::string number = name.substr(bracket + 1, name.size() - bracket - 2);
      if (name.back() != ']' || s.kind == Source::VARIABLE)
        lmp->error->all(FLERR, "{}: {} is not c_ID, c_ID[n], f_ID, f_ID[n] or v_name", what, text);
      s.column = integer_within(lmp, what + " column of " + text, number.c_str(), 1, 1000000);
      name = name.substr(0, bracket);
    }
  }
  s.name = name;
  for (size_t k = 0; k < sources.size(); k++)
    if (sources[k].kind == s.kind && sources[k].name == s.name && sources[k].column == s.column) return (int) k;
  if (s.kind == Source::OWN) {    // its compute refuses a name that it does not know
    if (!is_attribute(name))
      lmp->error->all(FLERR,
                      "{}: unknown criterion {}; known are region, neighbors, gradient, c_ID, f_ID, v_name "
                      "and the attributes of compute sph/tm/atom",
                      what, name);
    s.compute_id = fmt::format("{}_{}_{}", parts.id(), label, sources.size());
    lmp->modify->add_compute(fmt::format("{} all sph/tm/atom {}", s.compute_id, name));
  }
  sources.push_back(s);
  return (int) sources.size() - 1;
}

/* ---------------------------------------------------------------------- evaluation */

void RefineCriteria::init(int every)
{
  LAMMPS *lmp = parts.host();
  Error *error = lmp->error;
  const std::string what = fmt::format("Fix adapt/neigh {} when", label);
  auto fits = [&](const Source &s, const char *kind, bool per_atom, int columns) {
    if (!per_atom || (s.column > 0) != (columns > 0) || s.column > columns)
      error->all(FLERR, "{}: {} {} has {}; write {}", what, kind, s.name,
                 !per_atom ? "no values of particles"
                 : columns ? fmt::format("{} columns", columns)
                           : "one column",
                 !per_atom ? "one that has"
                 : columns ? fmt::format("{}[n] with n from 1 to {}", s.name, columns)
                           : fmt::format("{} without [n]", s.name));
  };
  for (const Source &s : sources) {
    if (s.kind == Source::COMPUTE) {
      const Compute *c = lmp->modify->get_compute_by_id(s.name);
      if (!c) error->all(FLERR, "{}: there is no compute {}", what, s.name);
      fits(s, "compute", c->peratom_flag, c->size_peratom_cols);
    } else if (s.kind == Source::FIX) {
      const Fix *f = lmp->modify->get_fix_by_id(s.name);
      if (!f) error->all(FLERR, "{}: there is no fix {}", what, s.name);
      fits(s, "fix", f->peratom_flag, f->size_peratom_cols);
      if (every % f->peratom_freq)
        error->all(FLERR, "{}: fix {} has values every {} steps, they are asked for every {}", what, s.name,
                   f->peratom_freq, every);
    } else if (s.kind == Source::VARIABLE) {
      const int v = lmp->input->variable->find(s.name.c_str());
      if (v < 0) error->all(FLERR, "{}: there is no variable {}", what, s.name);
      if (!lmp->input->variable->atomstyle(v)) error->all(FLERR, "{}: variable {} is not of style atom", what, s.name);
    }
  }
  for (const Term &t : terms)
    if (t.kind == REGION) {
      Region *region = lmp->domain->get_region_by_id(t.region);
      if (!region) error->all(FLERR, "{}: there is no region {}", what, t.region);
      region->init();
    }
}

void RefineCriteria::take_values(Source &s)
{
  LAMMPS *lmp = parts.host();
  const int n = lmp->atom->nlocal;
  s.values.resize(n);
  double *vector = nullptr, **array = nullptr;
  if (s.kind == Source::VARIABLE) {
    Variable *variable = lmp->input->variable;
    if (n) variable->compute_atom(variable->find(s.name.c_str()), 0, s.values.data(), 1, 0);
    else variable->compute_atom(variable->find(s.name.c_str()), 0, nullptr, 1, 0);
    return;
  }
  if (s.kind == Source::FIX) {
    const Fix *f = lmp->modify->get_fix_by_id(s.name);
    vector = f->vector_atom;
    array = f->array_atom;
  } else {
    Compute *c = lmp->modify->get_compute_by_id(s.kind == Source::OWN ? s.compute_id : s.name);
    if (!(c->invoked_flag & Compute::INVOKED_PERATOM)) {
      c->compute_peratom();
      c->invoked_flag |= Compute::INVOKED_PERATOM;
    }
    vector = c->vector_atom;
    array = c->array_atom;
  }
  for (int i = 0; i < n; i++) s.values[i] = s.column ? array[i][s.column - 1] : vector[i];
}

std::vector<char> RefineCriteria::test(const Term &t, Cloud &cloud)
{
  LAMMPS *lmp = parts.host();
  const int n = lmp->atom->nlocal;
  std::vector<char> holds(n);
  if (t.kind == REGION) {
    Region *region = lmp->domain->get_region_by_id(t.region);
    region->prematch();
    double **x = lmp->atom->x;
    for (int i = 0; i < n; i++) holds[i] = region->match(x[i][0], x[i][1], x[i][2]) != 0;
  } else {
    if (t.kind != VALUE) {
      cloud.take_values(t.kind == GRADIENT ? sources[t.source].values : std::vector<double>(n, 0.0));
      cloud.forward();
    }
    for (int i = 0; i < n; i++) {
      double value;
      if (t.kind == VALUE) value = sources[t.source].values[i];
      else if (t.kind == NEIGHBORS) value = cloud.count_within_support(i);
      else {
        const std::vector<int> &near = cloud.neighbors(i);
        const double h = cloud.size(i);
        tm_sym3 inverse;
        tm_cloud_moments(&cloud.view(), i, near.data(), (int) near.size(), h, &inverse);
        value = tm_vec_norm(
            tm_cloud_slope(&cloud.view(), i, near.data(), (int) near.size(), h, &inverse, TM_CLOUD_STATE).gradient);
      }
      holds[i] = t.above ? value > t.limit : value < t.limit;
    }
  }
  if (t.negate)
    for (char &c : holds) c = !c;
  return holds;
}

std::vector<char> RefineCriteria::hold(Cloud &cloud)
{
  for (Source &s : sources) take_values(s);
  const size_t n = parts.host()->atom->nlocal;
  std::vector<char> any(n, 0), all(n, 1);    // 'and' binds closer: a sum of products
  for (const Term &t : terms) {
    if (t.after_or)
      for (size_t i = 0; i < n; i++) {
        any[i] |= all[i];
        all[i] = 1;
      }
    const std::vector<char> holds = test(t, cloud);
    for (size_t i = 0; i < n; i++) all[i] &= holds[i];
  }
  for (size_t i = 0; i < n; i++) any[i] |= all[i];
  return any;
}

}    // namespace SPHTM_NS
