/* SPH-TM: how a style is registered with LAMMPS. */
#ifndef SPHTM_STYLE_REGISTRY_H
#define SPHTM_STYLE_REGISTRY_H

#include "error.h"
#include "force.h"
#include "lammps.h"
#include "lammpsplugin.h"
#include "modify.h"
#include "output.h"
#include "sphtm_config.h"

#include <cstring>
#include <list>
#include <map>
#include <string>

namespace SPHTM_NS {

// Styles with one argument list: pair. KOKKOS is what a LAMMPS that runs with Kokkos gets, STYLE itself
// where there is no other.
template <class STYLE, class KOKKOS> void *create_simple(void *ptr)
{
  auto *lmp = static_cast<LAMMPS_NS::LAMMPS *>(ptr);
  if (lmp->kokkos) return new KOKKOS(lmp);
  return new STYLE(lmp);
}

// styles made from command arguments: fix, compute
template <class STYLE, class KOKKOS> void *create_with_args(void *ptr, int narg, char **arg)
{
  auto *lmp = static_cast<LAMMPS_NS::LAMMPS *>(ptr);
  if (lmp->kokkos) return new KOKKOS(lmp, narg, arg);
  return new STYLE(lmp, narg, arg);
}

template <class STYLE> LAMMPS_NS::Dump *create_dump(LAMMPS_NS::LAMMPS *lmp, int narg, char **arg)
{
  return new STYLE(lmp, narg, arg);
}

// names with /kk where LAMMPS runs without Kokkos: they say so, where LAMMPS would only not know them
inline void *refuse(void *lmp, const char *name)
{
  static_cast<LAMMPS_NS::LAMMPS *>(lmp)->error->all(
      FLERR,
      "{} needs a LAMMPS with the KOKKOS package, started with '-k on'; here write the style "
      "without /kk",
      name);
  return nullptr;
}
inline void *refuse_pair(void *lmp) { return refuse(lmp, "Pair style sph/tm/kk"); }
inline void *refuse_with_args(void *lmp, int, char **arg) { return refuse(lmp, arg[2]); }
class Registry {
 public:
  Registry(void *lmp, void *handle, void *regfunc) :
      lmp_(static_cast<LAMMPS_NS::LAMMPS *>(lmp)), register_((lammpsplugin_regfunc) regfunc)
  {
    plugin_.version = SPHTM_LAMMPS_VERSION;
    plugin_.author = "SPH-TM developers";
    plugin_.handle = handle;
    kokkos_ = lmp_->kokkos;
  }
  template <class STYLE, class KOKKOS = STYLE> void pair(const char *name, const char *info)
  {
    const auto create = (lammpsplugin_factory1 *) &create_simple<STYLE, KOKKOS>;
    plugin_.creator.v1 = create;
    add("pair", name, info);
    plugin_.creator.v1 = kokkos_ ? create : (lammpsplugin_factory1 *) &refuse_pair;
    add_kokkos_names("pair", name, info);
  }
  template <class STYLE, class KOKKOS = STYLE> void fix(const char *name, const char *info)
  {
    with_args("fix", name, info, (lammpsplugin_factory2 *) &create_with_args<STYLE, KOKKOS>);
  }
  template <class STYLE, class KOKKOS = STYLE> void compute(const char *name, const char *info)
  {
    with_args("compute", name, info, (lammpsplugin_factory2 *) &create_with_args<STYLE, KOKKOS>);
  }
  // styles of LAMMPS's that have no variant with Kokkos
  template <class KOKKOS> void kokkos_fix(const char *name, const char *info)
  {
    plugin_.creator.v2 = (lammpsplugin_factory2 *) &create_with_args<KOKKOS, KOKKOS>;
    if (kokkos_) add_kokkos_names("fix", name, info);
  }
  template <class KOKKOS> void kokkos_compute(const char *name, const char *info)
  {
    plugin_.creator.v2 = (lammpsplugin_factory2 *) &create_with_args<KOKKOS, KOKKOS>;
    if (kokkos_) add_kokkos_names("compute", name, info);
  }
  // a fix of LAMMPS's with Kokkos, for this LAMMPS; quietly, as nothing that a user sees is another
  template <class KOKKOS> void in_place_of_kokkos_fix(const std::string &name)
  {
    if (!kokkos_) return;
    for (const char *suffix : {"/kk", "/kk/device"})
      (*lmp_->modify->fix_map)[name + suffix] = (LAMMPS_NS::Modify::FixCreator) &create_with_args<KOKKOS, KOKKOS>;
  }
  // LAMMPS takes no dump styles from plugins; its table is open to them
  template <class STYLE> void dump(const char *name) { (*lmp_->output->dump_map)[name] = &create_dump<STYLE>; }
  // a fix with values of particles in restart files: LAMMPS looks for them under the whole name of the
  // style, so there is one name, and none with /kk that a suffix would find
  template <class STYLE, class KOKKOS = STYLE> void state_fix(const char *name, const char *info)
  {
    plugin_.creator.v2 = (lammpsplugin_factory2 *) &create_with_args<STYLE, KOKKOS>;
    add("fix", name, info);
    plugin_.creator.v2 = (lammpsplugin_factory2 *) &refuse_with_args;
    if (!kokkos_) add_kokkos_names("fix", name, info);
  }

 private:
  void with_args(const char *style, const char *name, const char *info, lammpsplugin_factory2 *create)
  {
    plugin_.creator.v2 = create;
    add(style, name, info);
    plugin_.creator.v2 = kokkos_ ? create : (lammpsplugin_factory2 *) &refuse_with_args;
    add_kokkos_names(style, name, info);
  }
  void add_kokkos_names(const char *style, const char *name, const char *info)
  {
    static std::list<std::string> names;    // LAMMPS keeps the pointer
    for (const char *suffix : {"/kk", "/kk/device", "/kk/host"}) {
      names.push_back(std::string(name) + suffix);
      add(style, names.back().c_str(), info);
    }
  }
  void add(const char *style, const char *name, const char *info)
  {
    plugin_.style = style;
    plugin_.name = name;
    plugin_.info = info;
    (*register_)(&plugin_, lmp_);
    add_here();
  }
  // LAMMPS registers a style once in a process: a second instance in it would not know the style
  void add_here()
  {
    using namespace LAMMPS_NS;
    if (!strcmp(plugin_.style, "pair")) put<Force::PairCreator>(*lmp_->force->pair_map, plugin_.creator.v1);
    else if (!strcmp(plugin_.style, "fix")) put<Modify::FixCreator>(*lmp_->modify->fix_map, plugin_.creator.v2);
    else put<Modify::ComputeCreator>(*lmp_->modify->compute_map, plugin_.creator.v2);
  }
  template <class CREATOR, class FUNCTION> void put(std::map<std::string, CREATOR> &known, FUNCTION *create)
  {
    known.insert({plugin_.name, (CREATOR) create});    // where it is missing
  }
  lammpsplugin_t plugin_;
  bool kokkos_ = false;    // LAMMPS runs with it
  LAMMPS_NS::LAMMPS *lmp_;
  lammpsplugin_regfunc register_;
};

}    // namespace SPHTM_NS

#endif
