/* SPH-TM: pair style sph/tm, neighbor rows from the host's list. */
#include "pair_sph_tm.h"

#include "fix_sph_tm.h"

#include "atom.h"
#include "neigh_list.h"

#include <algorithm>
#include <memory>
#include <numeric>

using namespace LAMMPS_NS;

// a contact pair that also conducts stands in two segments
std::vector<unsigned char> PairSPHTM::segments_of_types()
{
  const int n1 = atom_types + 1;
  const bool conduction = fix->has(TM_FX_CONDUCTION);
  meets_thermal = false;
  std::vector<unsigned char> segments((size_t) n1 * n1, 0);
  for (int t = 1; t < n1; t++)
    for (int u = 1; u < n1; u++) {
      const PairLaw &l = law(t, u);
      unsigned char &s = segments[t * n1 + u];
      if (l.meeting == BOND && material[t].body == TM_BODY_SOLID) s |= TM_MEETS_MECHANICAL;
      if (conduction && (l.meeting == HEAT_ONLY || (l.meeting == CONTACT && l.conductance >= 0.0)))
        s |= TM_MEETS_THERMAL;
      if (l.meeting == CONTACT) s |= TM_MEETS_CONTACT;
      meets_thermal = meets_thermal || (s & TM_MEETS_THERMAL);
    }
  return segments;
}

void PairSPHTM::make_room_for_rows()
{
  const size_t n = (size_t) atom->nlocal + 1;
  row_first.make_room(true, n);
  for (auto *a : {&row_mechanical, &row_thermal, &row_contact}) a->make_room(true, n);
}

/* ----------------------------------------------------------------------
   rows: mechanical neighbours, heat-only ones, contact candidates; each
   segment in order of tag, so that sums do not depend on the order in memory.
   No row is sorted: the pairs are put into columns, one per particle, and the
   columns, walked in order of tag, deal their particle out to the rows
------------------------------------------------------------------------- */

void PairSPHTM::build_rows()
{
  const int nlocal = atom->nlocal, nall = nlocal + atom->nghost, *type = atom->type;
  const int n1 = atom_types + 1;
  const tagint *tag = atom->tag;
  const std::vector<unsigned char> segments = segments_of_types();

  // images of one particle in order of memory
  std::vector<int> by_tag(nall);
  std::iota(by_tag.begin(), by_tag.end(), 0);
  std::sort(by_tag.begin(), by_tag.end(), [tag](int a, int b) {
    return tag[a] != tag[b] ? tag[a] < tag[b] : a < b;
  });
  struct Particle {
    int rank, type;
  };
  std::vector<Particle> particle(nall);
  for (int r = 0; r < nall; r++) particle[by_tag[r]] = {r, type[by_tag[r]]};

  make_room_for_rows();
  int *mechanicals = row_mechanical.host_write(), *thermals = row_thermal.host_write();
  int *contacts = row_contact.host_write();
  ptrdiff_t *first = row_first.host_write();
  std::vector<ptrdiff_t> column_end(nall + 1, 0);
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii], *jlist = list->firstneigh[i], jnum = list->numneigh[i];
    const unsigned char *with = segments.data() + (ptrdiff_t) type[i] * n1;
    int mechanical = 0, thermal = 0, contact = 0;
    for (int jj = 0; jj < jnum; jj++) {
      const Particle p = particle[jlist[jj] & NEIGHMASK];
      const int s = with[p.type];
      mechanical += (s & TM_MEETS_MECHANICAL) != 0;
      thermal += (s & TM_MEETS_THERMAL) != 0;
      contact += (s & TM_MEETS_CONTACT) != 0;
      column_end[p.rank + 1] += s != 0;
    }
    mechanicals[i] = mechanical;
    thermals[i] = thermal;
    contacts[i] = contact;
  }
  // starts, which the next pass moves to the ends
  std::partial_sum(column_end.begin(), column_end.end(), column_end.begin());
  std::unique_ptr<unsigned[]> column(new unsigned[column_end[nall] + 1]);
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii], *jlist = list->firstneigh[i], jnum = list->numneigh[i];
    const unsigned char *with = segments.data() + (ptrdiff_t) type[i] * n1;
    for (int jj = 0; jj < jnum; jj++) {
      const Particle p = particle[jlist[jj] & NEIGHMASK];
      const unsigned s = with[p.type];
      if (s) column[column_end[p.rank]++] = ((unsigned) i << TM_SEGMENTS) | s;
    }
  }

  std::vector<ptrdiff_t> next[3];
  for (auto &n : next) n.resize(nlocal);
  ptrdiff_t total = 0;
  for (int i = 0; i < nlocal; i++) {
    first[i] = next[0][i] = total;
    next[1][i] = next[0][i] + mechanicals[i];
    next[2][i] = next[1][i] + thermals[i];
    total = next[2][i] + contacts[i];
  }
  row_index.make_room(true, total + 1);
  int *index = row_index.host_write();
  ptrdiff_t k = 0;
  for (int r = 0; r < nall; r++)
    for (; k < column_end[r]; k++) {
      const unsigned i = column[k] >> TM_SEGMENTS;
      if (column[k] & TM_MEETS_MECHANICAL) index[next[0][i]++] = by_tag[r];
      if (column[k] & TM_MEETS_THERMAL) index[next[1][i]++] = by_tag[r];
      if (column[k] & TM_MEETS_CONTACT) index[next[2][i]++] = by_tag[r];
    }
}
