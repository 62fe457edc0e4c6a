#include "adapt_parts.h"

#include "adapt_part.h"
#include "argument.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

AdaptParts::AdaptParts(LAMMPS *l, Fix &owner) : lmp(l), fix(owner), run(Scene::of(l)) {}
AdaptParts::~AdaptParts() = default;
int AdaptParts::owned() const { return lmp->atom->nlocal; }
int AdaptParts::owned_and_ghosts() const { return lmp->atom->nlocal + lmp->atom->nghost; }
std::string AdaptParts::id() const { return fix.id; }
int AdaptParts::group_bit() const { return fix.groupbit; }
void AdaptParts::renew_lists() { fix.next_reneighbor = lmp->update->ntimestep + 1; }

void AdaptParts::add(std::unique_ptr<AdaptPart> p) { parts.push_back(std::move(p)); }

void AdaptParts::read(Keywords k)
{
  while (k.next()) {
    if (std::any_of(parts.begin(), parts.end(), [&k](const auto &p) { return p->keyword(k); })) continue;
    std::string words, options;
    for (const auto &p : parts) {
      const std::vector<std::string> own = p->keywords(), behind = p->options();
      words += (words.empty() ? "" : ", ") + utils::join_words(own, ", ");
      if (!behind.empty()) options += "; options of " + own[0] + " are " + utils::join_words(behind, ", ");
    }
    k.unknown(words + options);
  }
  for (const auto &p : parts) {
    if (!p->in_use()) continue;
    in_use.push_back(p.get());
    if (ParticleValues *v = p->values()) moving.push_back(v);
  }
}

void AdaptParts::find_run()
{
  particles = &run->state("Fix adapt/neigh");
  if (!run->has_pair()) lmp->error->all(FLERR, "Fix adapt/neigh needs pair style sph/tm");
  if (lmp->modify->get_fix_by_style("^adapt/neigh").size() > 1)
    lmp->error->all(FLERR, "More than one fix adapt/neigh: write all its keywords in one");
}

bool AdaptParts::uses(const std::string &keyword) const
{
  for (const AdaptPart *p : in_use)
    for (const std::string &k : p->keywords())
      if (k == keyword) return true;
  return false;
}

bool AdaptParts::on_host() const
{
  return std::any_of(in_use.begin(), in_use.end(), [](const AdaptPart *p) { return p->on_host(); });
}

void AdaptParts::update_packed_size()
{
  fix.maxexchange = 0;
  for (const ParticleValues *v : moving) fix.maxexchange += v->most_packed();
}

void AdaptParts::offer() const
{
  Scene::Adaptation a;
  for (AdaptPart *p : in_use) p->offer(a);
  run->set_adaptation(a);
}

void AdaptParts::communicate(LoopArray<tm_real> &values, int columns)
{
  results().communicate(lmp->force->pair_match("^sph/tm", 0), values, columns);
}

void AdaptParts::forward(double *rows, int columns)
{
  forward_rows = rows;
  forward_columns = columns;
  lmp->comm->forward_comm(&fix, columns);
}

}    // namespace SPHTM_NS
