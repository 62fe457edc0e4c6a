#include "pair_laws.h"

#include "tm_neighbors.h"

#include <algorithm>

namespace SPHTM_NS {

void PairLaws::resize(int types)
{
  n = types + 1;
  laws.assign((size_t) n * n, PairLaw());
}

void PairLaws::set(int i, int j, const PairLaw &law)
{
  laws[i * n + j] = law;
  laws[j * n + i] = law;
}

std::vector<std::pair<int, int>> PairLaws::complete(const tm_material *material)
{
  std::vector<std::pair<int, int>> bonded;
  for (int i = 1; i < n; i++)
    for (int j = i; j < n; j++) {
      PairLaw l = (*this)(i, j);
      if (l.meeting != UNSET) continue;
      const bool heat = material[i].body == TM_BODY_HEAT || material[j].body == TM_BODY_HEAT;
      l.meeting = heat ? HEAT_ONLY : BOND;
      if (i != j && !heat) bonded.emplace_back(i, j);
      set(i, j, l);
    }
  return bonded;
}

bool PairLaws::has_contact() const
{
  return std::any_of(laws.begin(), laws.end(), [](const PairLaw &l) { return l.meeting == CONTACT; });
}

bool PairLaws::has_friction() const
{
  return std::any_of(laws.begin(), laws.end(),
                     [](const PairLaw &l) { return l.meeting == CONTACT && l.has_friction(); });
}

bool PairLaws::of_one_density(const tm_material *material) const
{
  for (int i = 1; i < n; i++)
    for (int j = i + 1; j < n; j++)
      if ((*this)(i, j).meeting == BOND && material[i].rho0 != material[j].rho0) return false;
  return true;
}

int PairLaws::contact_sides(std::vector<int> &side) const
{
  std::vector<int> body(n);    // the lowest type that a type is bonded to, in a chain
  for (int t = 0; t < n; t++) body[t] = t;
  for (int i = 1; i < n; i++)
    for (int j = i + 1; j < n; j++) {
      if ((*this)(i, j).meeting != BOND || body[i] == body[j]) continue;
      const int from = std::max(body[i], body[j]), to = std::min(body[i], body[j]);
      std::replace(body.begin(), body.end(), from, to);
    }
  side.assign((size_t) n * n, 0);
  int most = 0;
  for (int i = 1; i < n; i++) {
    std::vector<int> met;
    for (int j = 1; j < n; j++) {
      if ((*this)(i, j).meeting != CONTACT) continue;
      const auto it = std::find(met.begin(), met.end(), body[j]);
      side[i * n + j] = 1 + int(it - met.begin());
      if (it == met.end()) met.push_back(body[j]);
    }
    most = std::max(most, (int) met.size());
  }
  return most;
}

std::vector<std::pair<int, int>> PairLaws::that_pass(const tm_material *material) const
{
  std::vector<std::pair<int, int>> pass;
  for (int t = 1; t < n; t++)
    for (int u = t + 1; u < n; u++) {
      const auto meeting = (*this)(t, u).meeting;
      const bool solid = material[t].body == TM_BODY_SOLID && material[u].body == TM_BODY_SOLID;
      if (solid && (meeting == NONE || meeting == HEAT_ONLY)) pass.emplace_back(t, u);
    }
  return pass;
}

static bool is_thermal(const PairLaw &l)
{
  return l.meeting == HEAT_ONLY || (l.meeting == CONTACT && l.conductance >= 0.0);
}

bool PairLaws::has_thermal() const { return std::any_of(laws.begin(), laws.end(), is_thermal); }

std::vector<unsigned char> PairLaws::segments(const tm_material *material, bool conduction) const
{
  std::vector<unsigned char> segments((size_t) n * n, 0);
  for (int t = 1; t < n; t++)
    for (int u = 1; u < n; u++) {
      const PairLaw &l = (*this)(t, u);
      unsigned char &s = segments[t * n + u];
      if (l.meeting == BOND && material[t].body == TM_BODY_SOLID) s |= TM_MEETS_MECHANICAL;
      if (conduction && is_thermal(l)) s |= TM_MEETS_THERMAL;
      if (l.meeting == CONTACT) s |= TM_MEETS_CONTACT;
    }
  return segments;
}

}    // namespace SPHTM_NS
