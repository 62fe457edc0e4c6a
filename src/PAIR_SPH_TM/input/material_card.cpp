/* SPH-TM: a card in a file of material cards. */
#include "material_card.h"

#include "material_constants.h"
#include "plugin_folder.h"
#include "sphtm_config.h"

#include "comm.h"
#include "error.h"
#include "lammps.h"
#include "platform.h"
#include "tokenizer.h"
#include "utils.h"

#include <sys/stat.h>
#include <cstdio>
#include <mpi.h>

using namespace LAMMPS_NS;

namespace SPHTM_NS {
using namespace Material;

static std::string find_file(const char *name)
{
  std::string path = utils::get_potential_file_path(name);
  if (!path.empty()) return path;
  std::vector<std::string> folders = platform::list_pathenv("SPHTM_MATERIALS");
  folders.push_back(plugin_folder() + "/materials");                   // where it is built
  folders.push_back(plugin_folder() + "/" SPHTM_DATA "/materials");    // where it is installed
  for (const auto &folder : folders) {
    path = platform::path_join(folder, platform::path_basename(name));
    if (platform::file_is_readable(path)) return path;
  }
  return "";
}

// the whole file, read by rank 0
static std::string read_file(LAMMPS *lmp, const char *style, const char *name)
{
  std::string text;
  int size = -1;
  if (lmp->comm->me == 0) {
    const std::string path = find_file(name);
    struct stat s;
    const bool regular = !path.empty() && stat(path.c_str(), &s) == 0 && S_ISREG(s.st_mode);
    if (!path.empty() && !regular) lmp->error->one(FLERR, "{}: '{}' is not a regular file", style, path);
    constexpr off_t MOST = 100000000;
    if (regular && s.st_size > MOST)
      lmp->error->one(FLERR, "{}: '{}' has {} bytes; a file of material cards has at most {}", style, path, s.st_size,
                      MOST);
    FILE *fp = path.empty() ? nullptr : fopen(path.c_str(), "rb");
    if (fp) {
      char buffer[4096];
      std::size_t n;
      while ((n = fread(buffer, 1, sizeof(buffer), fp)) > 0) text.append(buffer, n);
      fclose(fp);
      size = (int) text.size();
    }
  }
  MPI_Bcast(&size, 1, MPI_INT, 0, lmp->world);
  if (size < 0)
    lmp->error->all(FLERR,
                    "{}: '{}' is neither a keyword ({}) nor a material file here, in the "
                    "folders of LAMMPS_POTENTIALS or SPHTM_MATERIALS, or beside the plugin",
                    style, name, known_keywords());
  text.resize(size);
  MPI_Bcast(&text[0], size, MPI_CHAR, 0, lmp->world);
  return text;
}

// lines with words, without comments; a final & continues a line
static std::vector<CardLine> split_lines(const std::string &text)
{
  std::vector<CardLine> lines;
  int number = 0;
  bool joined = false;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) end = text.size();
    std::string one = text.substr(begin, end - begin);
    one = one.substr(0, one.find('#'));
    begin = end + 1;
    number++;
    std::vector<std::string> words = Tokenizer(one, " \t\r\f").as_vector();
    if (words.empty()) continue;
    const bool more = words.back() == "&";
    if (more) words.pop_back();
    if (!joined) lines.push_back({number, {}});
    auto &all = lines.back().words;
    all.insert(all.end(), words.begin(), words.end());
    joined = more;
  }
  if (!lines.empty() && lines.back().words.empty()) lines.pop_back();    // a lone & at the end
  return lines;
}

std::vector<CardLine> find_card(LAMMPS *lmp, const char *style, const char *file, const char *name)
{
  std::vector<CardLine> card;
  std::vector<std::string> names;
  bool inside = false;
  auto fail = [&](int line, const std::string &what) {
    lmp->error->all(FLERR, "{}, {} line {}: {}", style, file, line, what);
  };
  int last = 0;
  for (const CardLine &line : split_lines(read_file(lmp, style, file))) {
    const std::string &first = line.words[0];
    last = line.number;
    if (first == "material") {
      if (inside) fail(line.number, "material before the 'end' of '" + names.back() + "'");
      if (line.words.size() != 2) fail(line.number, "expected 'material <name>'");
      for (const auto &n : names)
        if (n == line.words[1]) fail(line.number, "second material named '" + n + "'");
      names.push_back(line.words[1]);
      inside = true;
    } else if (!inside) {
      fail(line.number, "expected 'material <name>', got '" + first + "'");
    } else if (first == "end") {
      if (line.words.size() != 1) fail(line.number, "'end' stands alone, got '" + line.words[1] + "'");
      inside = false;
    } else if (names.back() == name) {
      card.push_back(line);
    }
  }
  if (inside) fail(last, "material '" + names.back() + "' has no 'end'");
  bool found = false;
  for (const auto &n : names) found = found || n == name;
  if (!found)
    lmp->error->all(FLERR, "{}: no material '{}' in {}; it has {}", style, name, file,
                    names.empty() ? "none" : join(names));
  return card;
}

}    // namespace SPHTM_NS
