#include "paraview_series.h"

#include "vtp_file.h"

#include "fmt/format.h"
#include "platform.h"
#include "utils.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

namespace {

const char *const SEPARATORS = "._-";
const char *const ENDING = ".vtp";

std::string file_of(const std::string &path)
{
  const size_t slash = path.rfind('/');
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

// what stands between two texts of a line, or false
bool between(const std::string &line, const char *before, const char *after, std::string &found)
{
  const size_t begin = line.find(before);
  if (begin == std::string::npos) return false;
  const size_t from = begin + strlen(before), end = line.find(after, from);
  if (end == std::string::npos) return false;
  found = line.substr(from, end - from);
  return true;
}

std::string plain_text(std::string text)
{
  for (const auto &name :
       {std::pair<const char *, const char *>{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}})
    for (size_t k = text.find(name.first); k != std::string::npos; k = text.find(name.first, k + 1))
      text.replace(k, strlen(name.first), name.second);
  return text;
}

std::string reason() { return errno ? strerror(errno) : "write failed"; }

}    // namespace

std::string ParaviewSeries::wrong_name(const std::string &pattern)
{
  if (!utils::strmatch(pattern, "\\.vtp$")) return "must end in .vtp";
  const auto stars = std::count(pattern.begin(), pattern.end(), '*');
  if (stars != 1) return stars ? "has more than one *" : "needs a * for the step";
  if (file_of(pattern).find('*') == std::string::npos) return "needs its * in the name of the file, not of the folder";
  if (pattern.find('%') != std::string::npos) return "has a %: the first rank writes one file for all";
  return "";
}

ParaviewSeries::ParaviewSeries(const std::string &pattern, const std::string &otherwise)
{
  const std::string file = file_of(pattern);
  folder = pattern.substr(0, pattern.size() - file.size());
  const size_t star = file.find('*');
  const size_t last = star ? file.find_last_not_of(SEPARATORS, star - 1) : std::string::npos;
  const std::string before = last == std::string::npos ? "" : file.substr(0, last + 1);
  std::string after = file.substr(star + 1, file.size() - star - 1 - strlen(ENDING));
  if (before.empty()) after.erase(0, after.find_first_not_of(SEPARATORS));
  stem = before + after;
  if (stem.empty()) stem = otherwise;
  pvd = folder + stem + ".pvd";
}

std::string ParaviewSeries::part_path(const std::string &part, const std::string &step) const
{
  return folder + stem + "_" + part + "_" + step + ENDING;
}

std::string ParaviewSeries::begin_anew()
{
  entries.clear();
  return write();
}

std::string ParaviewSeries::go_on(bigint now)
{
  entries.clear();
  std::ifstream old(pvd);
  for (std::string line; std::getline(old, line);) {
    if (line.find("<DataSet ") == std::string::npos) continue;
    std::string time, part, file, step;
    if (!between(line, " timestep=\"", "\"", time) || !between(line, " part=\"", "\"", part) ||
        !between(line, " file=\"", "\"", file) || !between(line, "<!-- step ", " -->", step))
      return fmt::format("cannot continue the list {}, which SPH-TM has not written: move it away", pvd);
    const bigint of = std::strtoll(step.c_str(), nullptr, 10);
    if (of <= now)    // the files of this step may be written again
      entries.push_back({of, std::strtod(time.c_str(), nullptr), std::atoi(part.c_str()), plain_text(file)});
  }
  return write();
}

std::string ParaviewSeries::enter(bigint step, double time, const std::vector<std::string> &files)
{
  entries.erase(std::remove_if(entries.begin(), entries.end(), [&](const Entry &e) { return e.step == step; }),
                entries.end());
  for (size_t k = 0; k < files.size(); k++) entries.push_back({step, time, (int) k, file_of(files[k])});
  return write();
}

void ParaviewSeries::drop_removed()
{
  std::vector<bigint> gone;
  for (const Entry &e : entries)
    if (e.part == 0 && !platform::file_is_readable(folder + e.file)) gone.push_back(e.step);
  const auto is_gone = [&](const Entry &e) { return std::find(gone.begin(), gone.end(), e.step) != gone.end(); };
  for (const Entry &e : entries)
    if (e.part && is_gone(e)) platform::unlink(folder + e.file);
  entries.erase(std::remove_if(entries.begin(), entries.end(), is_gone), entries.end());
}

std::string ParaviewSeries::write() const
{
  const std::string next = pvd + ".part";
  errno = 0;
  FILE *f = fopen(next.c_str(), "w");
  if (!f) return fmt::format("cannot write {}: {}", pvd, reason());
  fputs("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n", f);
  for (const Entry &e : entries)
    fputs(fmt::format("    <DataSet timestep=\"{}\" part=\"{}\" file=\"{}\"/><!-- step {} -->\n", e.time, e.part,
                      xml_text(e.file), e.step)
              .c_str(),
          f);
  fputs("  </Collection>\n</VTKFile>\n", f);
  const bool bad = ferror(f);
  if (fclose(f) != 0 || bad || rename(next.c_str(), pvd.c_str()) != 0)
    return fmt::format("cannot write {}: {}", pvd, reason());
  return "";
}

}    // namespace SPHTM_NS
