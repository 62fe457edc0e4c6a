#include "audit_patch.h"

#include "scene.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "neighbor.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

tm_records AuditPatch::records()
{
  auto part = [](std::vector<double> &v) { return v.empty() ? nullptr : v.data(); };
  tm_records r = {};
  r.main = part(main);
  r.stress = part(stress);
  r.heat = part(heat);
  r.size = part(size);
  r.correction = part(correction);
  r.hourglass = part(hourglass);
  r.stab = part(stab);
  r.faces = faces;
  return r;
}

AuditSearch::AuditSearch(LAMMPS *lmp, const ParticleState &state, const tm_records &r) :
    Pointers(lmp), rec(r),
    meets(state.model().pair_laws().segments(state.model().materials(), state.has(TM_FX_CONDUCTION)))
{
  const double began = RunClock::processor_time();
  const Model &model = state.model();
  const Settings &set = model.settings_in_use();
  const Atom &atoms = *atom;
  const int n = atoms.nlocal + atoms.nghost, dim = domain->dimension;
  radius = tm_kernel_support(set.kernel) * std::max(set.h, model.covered_h()) * (1.0 + 1e-9);
  farthest = radius + neighbor->skin;
  x.resize(3 * (size_t) n);
  for (int i = 0; i < n; i++) std::copy_n(rec.main + (size_t) i * TM_REC, 3, x.data() + 3 * (size_t) i);
  Backend &host = Backend::host();
  const SearchLoops &loops = SearchLoops::of(host);
  tm_cells &c = args.cells;
  c.n = n;
  c.x = x.data();
  tm_cells_make(&c, loops.bounds(host, n, {c.x}, 0u), farthest, farthest, dim == 3, 4 * n + 4096);
  cell.resize(n);
  begin.resize(tm_cells_number(&c) + 1);
  index.resize(n + TM_COLUMN_MOST);
  for (int d = 0; d < 3; d++) {
    column[d].resize(n + TM_COLUMN_MOST);
    c.column[d] = column[d].data();
  }
  c.cell = cell.data();
  c.begin = begin.data();
  c.index = index.data();
  loops.sort_into_cells(host, c);

  args.meets = meets.data();
  args.segments = TM_MEETS_MECHANICAL;
  args.type = atoms.type;
  args.tag = (const int *) atoms.tag;
  args.ntypes = atoms.ntypes;
  args.stride = 1;
  first.resize(atoms.nlocal);
  count.resize(atoms.nlocal);
  place.assign(n, -1);
  const double cut = farthest / model.smallest_spacing();
  const double lattice = dim == 3 ? 4.0 / 3.0 * TM_PI * cut * cut * cut : TM_PI * cut * cut;
  room = std::min((int) TM_SEARCH_MOST, (int) ceil(2.0 * lattice) + 8);
  seconds_of_sorting = RunClock::processor_time() - began;
}

AuditPatch AuditSearch::around(const std::vector<int> &centers, double within)
{
  const double began = RunClock::processor_time();
  const int n = (int) centers.size();
  std::vector<int> found;
  for (;;) {
    found.resize((size_t) n * room + 1);
    for (int k = 0; k < n; k++) first[centers[k]] = (ptrdiff_t) k * room;
    args.radius = within;
    args.capacity = room;
    args.which = centers.data();
    args.index = found.data();
    args.first = first.data();
    args.count[0] = count.data();
    const int longest = SearchLoops::of(Backend::host()).search(Backend::host(), n, args, 0u);
    if (longest <= room) break;
    if (longest > TM_SEARCH_MOST) error->one(FLERR, "Fix sph/tm audit: a particle has at least {} neighbors", longest);
    room = longest;
  }
  seconds_of_rows += RunClock::processor_time() - began;
  rows += n;

  AuditPatch p;
  p.centers = n;
  p.member = centers;
  for (int k = 0; k < n; k++) place[centers[k]] = k;
  p.none.assign(n, 0);
  for (const int i : centers) {
    p.first.push_back((ptrdiff_t) p.index.size());
    p.mechanical.push_back(count[i]);
    for (int k = 0; k < count[i]; k++) {
      const int j = found[first[i] + k];
      if (place[j] < 0) {
        place[j] = (int) p.member.size();
        p.member.push_back(j);
      }
      p.index.push_back(place[j]);
    }
  }
  for (const int i : p.member) place[i] = -1;
  gather(p);
  return p;
}

AuditPatch AuditSearch::alone(const std::vector<int> &centers) const
{
  AuditPatch p;
  p.centers = (int) centers.size();
  p.member = centers;
  for (auto *a : {&p.mechanical, &p.none}) a->assign(p.centers, 0);
  p.first.assign(p.centers, 0);
  gather(p);
  return p;
}

void AuditSearch::gather(AuditPatch &p) const
{
  auto take = [&](std::vector<double> &to, const double *from, int columns) {
    if (!from) return;
    to.reserve(p.member.size() * columns);
    for (const int i : p.member) to.insert(to.end(), from + (size_t) i * columns, from + (size_t) (i + 1) * columns);
  };
  take(p.main, rec.main, TM_REC);
  take(p.stress, rec.stress, TM_REC_STRESS);
  take(p.heat, rec.heat, TM_REC_HEAT);
  take(p.size, rec.size, TM_REC_SIZE);
  take(p.hourglass, rec.hourglass, TM_REC_HOURGLASS);
  take(p.stab, rec.stab, TM_REC_STAB);
  p.faces = rec.faces;
}

}    // namespace SPHTM_NS
