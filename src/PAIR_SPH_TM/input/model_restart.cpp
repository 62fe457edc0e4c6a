#include "model_restart.h"

#include "material_constants.h"
#include "restart_block.h"
#include "restart_scan.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "input.h"
#include "utils.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

namespace {
// what a file holds, of fixed size
struct SettingsRecord {
  Settings set;
  FrontHash front;
};
struct MaterialRecord {
  tm_material material;
  char title[64];
};
struct LawRecord {
  int given;
  PairLaw law;
};
struct TypesRecord {
  char fix[64];
  int types;
  uint64_t fix_names;    // see fix_names_hash()
};
const char *const WHO = "Pair style sph/tm";

void copy_text(char (&to)[64], const std::string &text)
{
  memset(to, 0, sizeof(to));
  memcpy(to, text.data(), std::min(text.size(), sizeof(to) - 1));
}
}    // namespace

void ModelRestart::write_settings(FILE *fp, const Settings &set)
{
  SettingsRecord r = {};
  r.set = set;
  r.front = front_hash(fp, file_name(fp));
  write_checked(fp, &r, sizeof(r));
}

void ModelRestart::write(FILE *fp, const Model &model, const std::string &fix_id, uint64_t fix_names, int **setflag)
{
  TypesRecord head = {};
  copy_text(head.fix, fix_id);
  head.types = model.types();
  head.fix_names = fix_names;
  write_checked(fp, &head, sizeof(head));
  for (int i = 1; i <= model.types(); i++) {
    MaterialRecord m = {};
    m.material = model.given_materials()[i];
    copy_text(m.title, model.material_name(i));
    write_checked(fp, &m, sizeof(m));
    for (int j = 1; j <= model.types(); j++) {
      LawRecord l = {};
      l.given = setflag[std::min(i, j)][std::max(i, j)];
      l.law = model.pair_laws()(i, j);
      write_checked(fp, &l, sizeof(l));
    }
  }
}

void ModelRestart::read(FILE *fp, Model &model, int **setflag)
{
  TypesRecord head;
  read_checked(lmp, WHO, fp, &head, sizeof(head));
  fix = head.fix;
  if (head.types != atom->ntypes)
    error->all(FLERR, "{}: the {} has {} types, the simulation {}", WHO, restart_file_name(lmp), head.types,
               atom->ntypes);
  written.reset(new Written);
  written->settings = model.settings_in_use();
  written->material.resize(head.types + 1);
  written->laws.resize((size_t) (head.types + 1) * (head.types + 1));
  for (int i = 1; i <= head.types; i++) {
    MaterialRecord m;
    read_checked(lmp, WHO, fp, &m, sizeof(m));
    model.set_material(i, m.material, m.title);
    written->material[i] = m.material;
    for (int j = 1; j <= head.types; j++) {
      LawRecord l;
      read_checked(lmp, WHO, fp, &l, sizeof(l));
      setflag[std::min(i, j)][std::max(i, j)] = l.given;
      model.pair_laws().set(i, j, l.law);
      written->laws[i * (head.types + 1) + j] = l.law;
    }
  }
  refuse_damaged(comm->me == 0 ? scan_restart(fp, name_of_parts(), head.fix_names) : "");
}

// of a file in parts its name with % where the one that is open has "base", or ""
std::string ModelRestart::name_of_parts() const
{
  if (input->narg < 1 || !strchr(input->arg[0], '%')) return "";
  std::string name = input->arg[0];
  if (name.find('*') == std::string::npos) return name;
  name = file;    // LAMMPS has found the number behind *
  const size_t at = name.rfind("base");
  if (at == std::string::npos) return "";
  return name.replace(at, 4, "%");
}

// of the first rank
void ModelRestart::refuse_damaged(const std::string &fault)
{
  std::string text = fault;
  int length = (int) text.size();
  MPI_Bcast(&length, 1, MPI_INT, 0, world);
  if (!length) return;
  text.resize(length);
  MPI_Bcast(&text[0], length, MPI_CHAR, 0, world);
  error->all(FLERR, "{}: the {} is damaged: {}", WHO, restart_file_name(lmp), text);
}

const std::string &ModelRestart::name_of_file(FILE *fp)
{
  file = comm->me == 0 ? file_name(fp) : "";
  int length = (int) file.size();
  MPI_Bcast(&length, 1, MPI_INT, 0, world);
  file.resize(length);
  MPI_Bcast(&file[0], length, MPI_CHAR, 0, world);
  return file;
}

Settings ModelRestart::read_settings(FILE *fp)
{
  FrontHash front;
  if (comm->me == 0) front = front_hash(fp, file);
  SettingsRecord r;
  read_checked(lmp, WHO, fp, &r, sizeof(r));
  const bool known = r.front.hash && front.hash;
  refuse_damaged(known && (front.bytes != r.front.bytes || front.hash != r.front.hash)
                     ? "the checksum of its head (box, groups, masses) does not fit"
                     : "");
  return r.set;
}

/* ---------------------------------------------------------------------- what differs from the run that wrote it */

namespace {
std::string change(const std::string &name, double then, double now)
{
  return fmt::format("{} was {:.8g}, is {:.8g}", name, then, now);
}

// as in the script
const char *correction_word(const Settings &set)
{
  if (!set.correction) return "no";
  return set.faces == FACES_NEVER ? "linear" : set.faces == FACES_ALWAYS ? "second" : "yes";
}

std::vector<std::string> changes(const Settings &then, const Settings &now)
{
  using S = Settings;
  // clang-format off
  static const struct { const char *name; double S::*value; } numbers[] = {
      {"ratio", &S::ratio}, {"spacing", &S::spacing}, {"viscosity alpha", &S::visc_alpha},
      {"viscosity beta", &S::visc_beta}, {"shock", &S::shock}, {"artstress", &S::art_eps}, {"xsph", &S::xsph}, {"hourglass", &S::hourglass}};
  static const struct { const char *name; bool S::*value; } flags[] = {
      {"artstress component", &S::art_component}, {"artstress balanced", &S::art_balanced}, {"form f14", &S::form_f14},
      {"balsara", &S::balsara}, {"plane stress", &S::plane_stress},
      {"precision mixed", &S::mixed}};
  // clang-format on
  std::vector<std::string> found;
  if (then.kernel != now.kernel)
    found.push_back(fmt::format("kernel was {}, is {}", kernel_name(then.kernel), kernel_name(now.kernel)));
  for (const auto &n : numbers)
    if (then.*n.value != now.*n.value) found.push_back(change(n.name, then.*n.value, now.*n.value));
  const std::string corrected = correction_word(then), corrects = correction_word(now);
  if (corrected != corrects) found.push_back(fmt::format("correction was {}, is {}", corrected, corrects));
  if (then.art_n != now.art_n) found.push_back(change("artstress exponent", then.art_n, now.art_n));
  for (const auto &f : flags)
    if (then.*f.value != now.*f.value)
      found.push_back(
          fmt::format("{} was {}, is {}", f.name, then.*f.value ? "yes" : "no", now.*f.value ? "yes" : "no"));
  return found;
}

bool same_table(const tm_table &a, const tm_table &b)
{
  return a.n == b.n && a.value == b.value && std::equal(a.t, a.t + a.n, b.t) && std::equal(a.y, a.y + a.n, b.y);
}

std::vector<std::string> changes(const tm_material &then, const tm_material &now)
{
  std::vector<std::string> found;
  for (const auto &c : Material::constants()) {
    if (c.number && then.*c.number != now.*c.number) found.push_back(change(c.name, then.*c.number, now.*c.number));
    if (c.table && !same_table(then.*c.table, now.*c.table))
      found.push_back((then.*c.table).n || (now.*c.table).n
                          ? std::string("table of ") + c.name + " differs"
                          : change(c.name, (then.*c.table).value, (now.*c.table).value));
  }
  for (const auto &g : Material::groups()) {
    if (!g.selector || then.*g.selector == now.*g.selector) continue;
    const std::string text = std::string(g.keyword) + " is another one";
    if (std::find(found.begin(), found.end(), text) == found.end()) found.push_back(text);
  }
  return found;
}
}    // namespace

// once, before the first run after read_restart
void ModelRestart::compare(const Model &model)
{
  if (!written) return;
  const std::unique_ptr<Written> then = std::move(written);
  for (int i = 1; i <= model.types(); i++)
    if (then->material[i].rho0 > 0.0 && then->material[i].rho0 != model.given_materials()[i].rho0)
      error->all(FLERR,
                 "{}: density of type {} ({}) was {:.8g} in the run that wrote the {}, is {:.8g}: the state of its "
                 "particles is that of another material",
                 WHO, i, model.material_name(i), then->material[i].rho0, restart_file_name(lmp),
                 model.given_materials()[i].rho0);
  if (comm->me) return;
  const std::string tail = " than in the run that wrote the " + restart_file_name(lmp);
  auto say = [&](const std::string &what, const std::vector<std::string> &found) {
    if (!found.empty()) error->warning(FLERR, "{}{} differs{}: {}", WHO, what, tail, utils::join_words(found, "; "));
  };
  say("", changes(then->settings, model.settings_in_use()));
  for (int i = 1; i <= model.types(); i++) {
    say(fmt::format(": type {} ({})", i, model.material_name(i)),
        changes(then->material[i], model.given_materials()[i]));
    for (int j = i + 1; j <= model.types(); j++) {
      const PairLaw &a = then->laws[i * (model.types() + 1) + j], &b = model.pair_laws()(i, j);
      if (a.meeting == b.meeting && a.conductance == b.conductance &&
          same_table(a.contact.friction, b.contact.friction) && a.contact.shear == b.contact.shear &&
          a.penalty == b.penalty && a.layer == b.layer && a.contact.damping == b.contact.damping)
        continue;
      error->warning(FLERR, "{}: how types {} and {} meet is set in another way{}", WHO, i, j, tail);
    }
  }
}

}    // namespace SPHTM_NS
