#include "scene.h"

#include "contact_probe.h"

#include "error.h"
#include "force.h"
#include "lammps.h"

#include <algorithm>
#include <map>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

std::shared_ptr<Scene> Scene::of(LAMMPS *lmp)
{
  static std::map<LAMMPS *, std::weak_ptr<Scene>> scenes;
  std::weak_ptr<Scene> &known = scenes[lmp];
  std::shared_ptr<Scene> scene = known.lock();
  if (!scene) known = scene = std::make_shared<Scene>(lmp);
  return scene;
}

ParticleState &Scene::state(const std::string &style) const
{
  if (states.empty())
    lmp->error->all(FLERR,
                    "{} needs a fix sph/tm, which owns the state of the particles; write 'fix body all sph/tm' "
                    "before it",
                    style);
  return *states.front();
}

bool Scene::is_current(ParticleState *known) const
{
  return known && known == state() && known->history().has_forces() && pair.model &&
         known->model_in_use() == pair.model && is_bound() && lmp->force->pair_match("^sph/tm", 0);
}

void Scene::check_current(ParticleState *known, const std::string &style) const
{
  if (!is_current(known))
    lmp->error->all(FLERR, "{} has no current values: there was no run since {} written; use 'run 0' first", style,
                    !state() ? "fix sph/tm was removed or" : "it, fix sph/tm or pair style sph/tm was");
}

void Scene::leave(ParticleState *s)
{
  states.erase(std::remove(states.begin(), states.end(), s), states.end());
  if (bound == s) bound = nullptr;
}

void Scene::leave(Model *m)
{
  if (pair.model != m) return;
  pair = {};
  bound = nullptr;    // another pair style may lie in the same place
}

void Scene::bind() { bound = state(); }

void Scene::leave(ContactProbe *p) { probes.erase(std::remove(probes.begin(), probes.end(), p), probes.end()); }

}    // namespace SPHTM_NS
