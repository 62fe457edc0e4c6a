/* SPH-TM: where the plugin was loaded from. */
#include "plugin_folder.h"

#include <cstdlib>
#include <dlfcn.h>

namespace SPHTM_NS {

static std::string find_folder()
{
  Dl_info here;
  if (!dladdr((const void *) &find_folder, &here) || !here.dli_fname) return ".";
  char *whole = realpath(here.dli_fname, nullptr);
  std::string path = whole ? whole : here.dli_fname;
  free(whole);
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : path.substr(0, slash);
}

static const std::string folder = find_folder();    // while it is loaded: a relative path holds only until a 'shell cd'

const std::string &plugin_folder() { return folder; }

}    // namespace SPHTM_NS
