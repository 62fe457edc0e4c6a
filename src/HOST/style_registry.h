/* SPH-TM: how a style is registered with LAMMPS. */
#ifndef SPHTM_STYLE_REGISTRY_H
#define SPHTM_STYLE_REGISTRY_H

#include "error.h"
#include "lammps.h"
#include "lammpsplugin.h"

#include <list>
#include <string>

namespace SPHTM_NS {

// styles with one argument list: pair
template <class STYLE> void *create_simple(void *lmp)
{
  return new STYLE(static_cast<LAMMPS_NS::LAMMPS *>(lmp));
}

// styles made from command arguments: fix, compute
template <class STYLE> void *create_with_args(void *lmp, int narg, char **arg)
{
  return new STYLE(static_cast<LAMMPS_NS::LAMMPS *>(lmp), narg, arg);
}

// names with /kk where LAMMPS runs without Kokkos: they say so, where LAMMPS would only not know them
inline void *refuse(void *lmp, const char *name)
{
  static_cast<LAMMPS_NS::LAMMPS *>(lmp)->error->all(
      FLERR, "{} needs a LAMMPS with the KOKKOS package, started with '-k on'; here write the style "
             "without /kk", name);
  return nullptr;
}
inline void *refuse_pair(void *lmp) { return refuse(lmp, "Pair style sph/tm/kk"); }
inline void *refuse_with_args(void *lmp, int, char **arg) { return refuse(lmp, arg[2]); }

class Registry {
 public:
  Registry(void *lmp, void *handle, void *regfunc) :
      lmp_(lmp), register_((lammpsplugin_regfunc) regfunc)
  {
    plugin_.version = SPHTM_LAMMPS_VERSION;
    plugin_.author = "SPH-TM developers";
    plugin_.handle = handle;
    without_kokkos_ = !static_cast<LAMMPS_NS::LAMMPS *>(lmp)->kokkos;
  }
  template <class STYLE> void pair(const char *name, const char *info)
  {
    plugin_.creator.v1 = (lammpsplugin_factory1 *) &create_simple<STYLE>;
    add("pair", name, info);
    plugin_.creator.v1 = (lammpsplugin_factory1 *) &refuse_pair;
    refuse_kokkos("pair", name);
  }
  template <class STYLE> void fix(const char *name, const char *info)
  {
    plugin_.creator.v2 = (lammpsplugin_factory2 *) &create_with_args<STYLE>;
    add("fix", name, info);
    plugin_.creator.v2 = (lammpsplugin_factory2 *) &refuse_with_args;
    refuse_kokkos("fix", name);
  }
  template <class STYLE> void compute(const char *name, const char *info)
  {
    plugin_.creator.v2 = (lammpsplugin_factory2 *) &create_with_args<STYLE>;
    add("compute", name, info);
    plugin_.creator.v2 = (lammpsplugin_factory2 *) &refuse_with_args;
    refuse_kokkos("compute", name);
  }

 private:
  void refuse_kokkos(const char *style, const char *name)
  {
    static std::list<std::string> names;    // LAMMPS keeps the pointer
    names.push_back(std::string(name) + "/kk");
    if (without_kokkos_) add(style, names.back().c_str(), "not without Kokkos");
  }
  void add(const char *style, const char *name, const char *info)
  {
    plugin_.style = style;
    plugin_.name = name;
    plugin_.info = info;
    (*register_)(&plugin_, lmp_);
  }
  lammpsplugin_t plugin_;
  bool without_kokkos_ = false;
  void *lmp_;
  lammpsplugin_regfunc register_;
};

}    // namespace SPHTM_NS

#endif
