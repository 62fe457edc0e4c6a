/* SPH-TM: how a style is registered with LAMMPS. */
#ifndef SPHTM_STYLE_REGISTRY_H
#define SPHTM_STYLE_REGISTRY_H

#include "lammps.h"
#include "lammpsplugin.h"

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

class Registry {
 public:
  Registry(void *lmp, void *handle, void *regfunc) :
      lmp_(lmp), register_((lammpsplugin_regfunc) regfunc)
  {
    plugin_.version = SPHTM_LAMMPS_VERSION;
    plugin_.author = "SPH-TM developers";
    plugin_.handle = handle;
  }
  template <class STYLE> void pair(const char *name, const char *info)
  {
    plugin_.creator.v1 = (lammpsplugin_factory1 *) &create_simple<STYLE>;
    add("pair", name, info);
  }
  template <class STYLE> void fix(const char *name, const char *info)
  {
    plugin_.creator.v2 = (lammpsplugin_factory2 *) &create_with_args<STYLE>;
    add("fix", name, info);
  }
  template <class STYLE> void compute(const char *name, const char *info)
  {
    plugin_.creator.v2 = (lammpsplugin_factory2 *) &create_with_args<STYLE>;
    add("compute", name, info);
  }

 private:
  void add(const char *style, const char *name, const char *info)
  {
    plugin_.style = style;
    plugin_.name = name;
    plugin_.info = info;
    (*register_)(&plugin_, lmp_);
  }
  lammpsplugin_t plugin_;
  void *lmp_;
  lammpsplugin_regfunc register_;
};

}    // namespace SPHTM_NS

#endif
