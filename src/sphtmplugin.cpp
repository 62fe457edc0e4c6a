/* SPH-TM: entry point of the plugin. It takes nothing from LAMMPS but functions of its C interface, by their names, so that
   it loads into any LAMMPS and can say what does not fit. The styles are in sphtm_styles.so beside it, which is loaded only
   into a LAMMPS like the one they were compiled for: elsewhere symbols are missing, or classes are laid out in another way
   without a word (LAMMPS itself only prints a note). */
#include "sphtm_config.h"

#include <cctype>
#include <cstdio>
#include <cstring>
#include <dlfcn.h>
#include <mpi.h>    // only for its macros: which MPI the styles are compiled for
#include <string>

#define TEXT_OF(number) #number
#define TEXT(number) TEXT_OF(number)

#if defined(LAMMPS_BIGBIG)
#define BUILT_SIZES "bigbig"
#elif defined(LAMMPS_SMALLSMALL)
#define BUILT_SIZES "smallsmall"
#else
#define BUILT_SIZES "smallbig"
#endif
#if defined(MPI_STUBS)
#define BUILT_MPI "no MPI"
#elif defined(OMPI_MAJOR_VERSION)
#define BUILT_MPI "Open MPI " TEXT(OMPI_MAJOR_VERSION) "." TEXT(OMPI_MINOR_VERSION) "." TEXT(OMPI_RELEASE_VERSION)
#elif defined(I_MPI_VERSION)
#define BUILT_MPI "Intel MPI " I_MPI_VERSION
#elif defined(MPICH_VERSION)
#define BUILT_MPI "MPICH " MPICH_VERSION
#else
#define BUILT_MPI "an unknown MPI"
#endif
#ifdef LMP_KOKKOS
#define BUILT_KOKKOS "with Kokkos"
#else
#define BUILT_KOKKOS "without Kokkos"
#endif

namespace {

struct Build {    // of LAMMPS; the texts are for messages too
  std::string version, sizes, mpi, kokkos;
  std::string text() const { return "LAMMPS " + version + ", " + sizes + ", " + mpi + ", " + kokkos; }
};

// Read when the plugin is loaded, so that all there is to compare is in this line; ./sphtm doctor looks for it in the file
const char *volatile built_for = "built for LAMMPS " SPHTM_LAMMPS_VERSION ", " BUILT_SIZES ", " BUILT_MPI
                                 ", " BUILT_KOKKOS;

Build wanted()
{
  std::string rest = built_for + strlen("built for LAMMPS "), word[4];
  for (std::string &w : word) {
    const std::size_t comma = rest.find(", ");
    w = rest.substr(0, comma);
    rest = comma == std::string::npos ? "" : rest.substr(comma + 2);
  }
  return {word[0], word[1], word[2], word[3]};
}

template <class FUNCTION> FUNCTION *host_function(const char *name) { return (FUNCTION *) dlsym(RTLD_DEFAULT, name); }

// 4 Feb 2025 from 20250204
std::string date_of(int number)
{
  static const char MONTHS[] = "JanFebMarAprMayJunJulAugSepOctNovDec";
  const int month = number / 100 % 100;
  if (month < 1 || month > 12) return "of an unknown version";
  return std::to_string(number % 100) + " " + std::string(MONTHS + 3 * (month - 1), 3) + " " +
         std::to_string(number / 10000);
}

std::string sizes_of(int tagint, int imageint, int bigint)
{
  if (tagint == 4 && imageint == 4 && bigint == 8) return "smallbig";
  if (tagint == 8 && imageint == 8 && bigint == 8) return "bigbig";
  if (tagint == 4 && imageint == 4 && bigint == 4) return "smallsmall";
  return "tagint " + std::to_string(8 * tagint) + ", imageint " + std::to_string(8 * imageint) + ", bigint " +
         std::to_string(8 * bigint) + " bits";
}

// the beginning of what the MPI library says of itself, to the first comma or the end of the line
std::string mpi_of_host()
{
  auto has_mpi = host_function<int()>("lammps_config_has_mpi_support");
  if (has_mpi && !has_mpi()) return "no MPI";
  auto version = host_function<int(char *, int *)>("MPI_Get_library_version");
  std::string text(16384, '\0');    // more than any MPI_MAX_LIBRARY_VERSION_STRING
  int length = 0;
  if (!version || version(&text[0], &length) != 0) return "an unknown MPI";
  text = text.substr(0, text.find_first_of(std::string(",\n\0", 3)));
  for (char &c : text)
    if (isspace((unsigned char) c)) c = ' ';
  return text;
}

// libraries of one family take each other's programs; Intel MPI, MVAPICH and Cray MPICH are of MPICH's
std::string mpi_family(const std::string &name)
{
  if (name == "no MPI") return name;
  if (name.find("Open MPI") != std::string::npos) return "Open MPI";
  for (const char *word : {"MPICH", "Intel", "MVAPICH"})
    if (name.find(word) != std::string::npos) return "MPICH";
  return "";
}

Build ask_host(void *lmp)
{
  auto version = host_function<int(void *)>("lammps_version");
  auto setting = host_function<int(void *, const char *)>("lammps_extract_setting");
  auto package = host_function<int(const char *)>("lammps_config_has_package");
  return {version ? date_of(version(lmp)) : "of an unknown version",
          setting ? sizes_of(setting(lmp, "tagint"), setting(lmp, "imageint"), setting(lmp, "bigint"))
                  : "unknown sizes",
          mpi_of_host(), package && package("KOKKOS") ? "with Kokkos" : "without Kokkos"};
}

bool fits(const Build &want, const Build &host)
{
  const std::string family = mpi_family(want.mpi), there = mpi_family(host.mpi);
  return host.version == want.version && host.sizes == want.sizes &&
         (family.empty() || there.empty() || family == there) &&
         (want.kokkos == "without Kokkos" || host.kokkos == "with Kokkos");
}

// rank 0, as a warning of LAMMPS where it has a function for that
void warn(void *lmp, const std::string &text)
{
  auto setting = host_function<int(void *, const char *)>("lammps_extract_setting");
  if (setting && setting(lmp, "world_rank") > 0) return;
  auto error = host_function<void(void *, int, const char *)>("lammps_error");
  constexpr int WARNING = 0;    // LMP_ERROR_WARNING
  if (error) error(lmp, WARNING, text.c_str());
  else fprintf(stderr, "WARNING: %s\n", text.c_str());
}

std::string own_folder()
{
  Dl_info here;
  if (!dladdr((const void *) &built_for, &here) || !here.dli_fname) return ".";
  const std::string path = here.dli_fname;
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : path.substr(0, slash);
}

}    // namespace

extern "C" __attribute__((visibility("default"))) void lammpsplugin_init(void *lmp, void *handle, void *regfunc)
{
  const std::string rebuild =
      "To build it for this LAMMPS, in the folder of SPH-TM's source: cmake -S . -B build/own -D LAMMPS_SOURCE_DIR="
      "<LAMMPS's source> -D LAMMPS_BUILD_DIR=<LAMMPS's build> && cmake --build build/own";
  const Build want = wanted(), host = ask_host(lmp);
  if (!fits(want, host)) {
    warn(lmp, "SPH-TM was built for " + want.text() + ", and is not loaded into " + host.text() + ". " + rebuild);
    return;
  }
  const std::string path = own_folder() + "/sphtm_styles.so";
  void *styles = dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
  auto add = styles ? (void (*)(void *, void *, void *)) dlsym(styles, "sphtm_register_styles") : nullptr;
  if (add) add(lmp, handle, regfunc);
  else {
    const char *why = dlerror();
    warn(lmp, std::string("SPH-TM's styles are not loaded: ") + (why ? why : path.c_str()) + ". " + rebuild);
  }
}
