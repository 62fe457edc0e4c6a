/* SPH-TM: dump sph/tm/vtp. See doc/dump_sph_tm_vtp.rst. */
#include "dump_sph_tm_vtp.h"

#include "argument.h"
#include "compute_sph_tm_atom.h"
#include "contact_probe.h"
#include "scene.h"

#include "arg_info.h"
#include "domain.h"
#include "error.h"
#include "modify.h"
#include "output.h"
#include "update.h"

#include <algorithm>
#include <cstring>
#include <set>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

namespace {

// attributes that are one vector in the file
struct Triple {
  const char *name, *of[3];
};
constexpr Triple TRIPLES[] = {{"velocity", {"vx", "vy", "vz"}},
                              {"force", {"fx", "fy", "fz"}},
                              {"image", {"ix", "iy", "iz"}},
                              {"unwrapped", {"xu", "yu", "zu"}}};
constexpr const char *POSITION[3] = {"x", "y", "z"}, *UNWRAPPED[3] = {"xu", "yu", "zu"};

}    // namespace

DumpSPHTMVtp::DumpSPHTMVtp(LAMMPS *lmp, int narg, char **arg) :
    DumpCustom(lmp, narg, arg), scene(Scene::of(lmp)), series(arg[4], arg[0]), attributes(earg, earg + nfield)
{
  const std::string wrong = ParaviewSeries::wrong_name(filename);
  if (!wrong.empty()) error->all(FLERR, "{}: file name {} {}", what(), filename, wrong);
  buffer_allow = buffer_flag = 0;    // numbers, not text
  for (int k = 0; k < nfield; k++)
    if (vtype[k] == Dump::STRING || vtype[k] == Dump::STRING2)
      error->all(FLERR, "{}: attribute {} is a text and cannot be written, use type", what(), attributes[k]);
  std::vector<int> found;
  if (!find_triple(POSITION, found) && !find_triple(UNWRAPPED, found))
    error->all(FLERR, "{}: needs the attributes x y z (or xu yu zu), the places of the points", what());
}

DumpSPHTMVtp::~DumpSPHTMVtp() = default;

std::string DumpSPHTMVtp::what() const { return fmt::format("Dump sph/tm/vtp {}", id); }

int DumpSPHTMVtp::modify_param(int narg, char **arg)
{
  const std::string keyword = fmt::format("Dump_modify {} {}", id, arg[0]);
  if (strcmp(arg[0], "precision") == 0) {
    if (narg < 2) utils::missing_cmd_args(FLERR, keyword, error);
    single = strcmp(arg[1], "single") == 0;
    if (!single && strcmp(arg[1], "double") != 0)
      error->all(FLERR, "{} of dump sph/tm/vtp: {} is neither single nor double", keyword, arg[1]);
    return 2;
  }
  if (strcmp(arg[0], "tools") == 0) {
    if (narg < 2) utils::missing_cmd_args(FLERR, keyword, error);
    tools = yes_no(lmp, keyword, arg[1]);
    return 2;
  }
  if (strcmp(arg[0], "format") == 0 && narg > 1 && strcmp(arg[1], "none") != 0)
    error->all(FLERR, "{} has no meaning for dump sph/tm/vtp, whose numbers are binary: use precision", keyword);
  return DumpCustom::modify_param(narg, arg);
}

/* ---------------------------------------------------------------------- what is in a file */

int DumpSPHTMVtp::column(const std::string &attribute) const
{
  const auto found = std::find(attributes.begin(), attributes.end(), attribute);
  return found == attributes.end() ? -1 : (int) (found - attributes.begin());
}

// in two dimensions the third may be missing: it is 0
bool DumpSPHTMVtp::find_triple(const char *const of[3], std::vector<int> &columns) const
{
  columns = {column(of[0]), column(of[1]), column(of[2])};
  return columns[0] >= 0 && columns[1] >= 0 && (columns[2] >= 0 || domain->dimension == 2);
}

// as given by dump_modify, or what compute sph/tm/atom calls it, or the attribute
std::string DumpSPHTMVtp::column_name(int k) const
{
  if (!keyword_user[k].empty()) return keyword_user[k];
  const ArgInfo argument(attributes[k], ArgInfo::COMPUTE);
  if (argument.get_type() != ArgInfo::COMPUTE) return attributes[k];
  const auto *ours = dynamic_cast<ComputeSPHTMAtom *>(modify->get_compute_by_id(argument.get_name()));
  return ours ? ours->attribute(std::max(argument.get_index1() - 1, 0)) : attributes[k];
}

void DumpSPHTMVtp::plan_values()
{
  const VtpFile::Type real = single ? VtpFile::FLOAT32 : VtpFile::FLOAT64;
  values.clear();
  std::vector<bool> used(nfield, false);
  const auto add = [&](VtpFile::Place place, const std::string &name, const std::vector<int> &columns) {
    const int type = vtype[columns[0]];
    const VtpFile::Type kind = type == Dump::INT ? VtpFile::INT32 : type == Dump::BIGINT ? VtpFile::INT64 : real;
    values.push_back({{place, name, kind, (int) columns.size()}, columns});
    for (const int k : columns)
      if (k >= 0) used[k] = true;
  };
  std::vector<int> columns;
  if (!find_triple(POSITION, columns)) find_triple(UNWRAPPED, columns);
  add(VtpFile::POINTS, "Points", columns);
  for (const Triple &t : TRIPLES)
    if (find_triple(t.of, columns) && !used[columns[0]])
      add(VtpFile::POINT_DATA, keyword_user[columns[0]].empty() ? t.name : keyword_user[columns[0]], columns);
  std::vector<std::string> names(nfield);
  for (int k = 0; k < nfield; k++) names[k] = column_name(k);
  for (int k = 0; k < nfield; k++) {
    if (used[k]) continue;
    // two computes with the same value keep their own names
    const bool alone = !keyword_user[k].empty() || std::count(names.begin(), names.end(), names[k]) == 1;
    add(VtpFile::POINT_DATA, alone ? names[k] : attributes[k], {k});
  }
  std::set<std::string> known;
  for (const Values &v : values)
    if (!known.insert(v.array.name).second)
      error->all(FLERR, "{}: two columns are called {}: leave one out, or rename it with dump_modify colname", what(),
                 v.array.name);
}

/* ---------------------------------------------------------------------- writing */

void DumpSPHTMVtp::init_style()
{
  DumpCustom::init_style();
  if (!write_header_flag) error->all(FLERR, "{}: dump_modify header no has no meaning here, leave it out", what());
  plan_values();
  for (const Dump *other : output->get_dump_list()) {
    const auto *vtp = dynamic_cast<const DumpSPHTMVtp *>(other);
    if (vtp && vtp != this && vtp->series.path() == series.path())
      error->all(FLERR, "{}: dump {} has the list {} too: give the files of one another name before their *", what(),
                 vtp->id, series.path());
  }
  begin_series();
}

void DumpSPHTMVtp::check_series(const std::string &wrong)
{
  if (!wrong.empty()) error->one(FLERR, "{}: {}", what(), wrong);
}

void DumpSPHTMVtp::begin_series()
{
  if (!begun && me == 0) check_series(append_flag ? series.go_on(update->ntimestep) : series.begin_anew());
  begun = true;
}

// a file for each step is never appended to: append is for the list of files
void DumpSPHTMVtp::openfile()
{
  const int append = append_flag;
  append_flag = 0;
  DumpCustom::openfile();
  append_flag = append;
}

void DumpSPHTMVtp::write_header(bigint particles)
{
  if (values.empty()) error->one(FLERR, "{}: a new dump cannot be followed by 'run pre no'", what());
  std::vector<VtpFile::Array> arrays;
  for (const Values &v : values) arrays.push_back(v.array);
  file = std::make_unique<VtpFile>(fp, particles, 0);
  file->begin(arrays, compute_time());
  rows_done = 0;
}

void DumpSPHTMVtp::write_data(int n, double *rows)
{
  for (size_t k = 0; k < values.size(); k++) file->put(k, rows_done, n, rows, size_one, values[k].columns);
  rows_done += n;
}

void DumpSPHTMVtp::write_footer()
{
  file->end();
  file.reset();
  written = true;
}

void DumpSPHTMVtp::write()
{
  written = false;
  DumpCustom::write();
  if (!written) return;    // skipped, or not the first rank
  const std::string name = utils::star_subst(filename, update->ntimestep, padflag);
  std::vector<std::string> files = {name};
  if (maxfiles > 0) series.drop_removed();
  for (ContactProbe *tool : scene->contact_probes()) {
    if (!tools) break;
    const std::string step = utils::star_subst("*", update->ntimestep, padflag);
    files.push_back(series.part_path(tool->tool_name, step));
    check_series(tool->write_surface(files.back(), compute_time()));
  }
  check_series(series.enter(update->ntimestep, compute_time(), files));
}
