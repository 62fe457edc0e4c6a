/* SPH-TM: fix adapt/neigh. See doc/fix_adapt_neigh.rst. */
#include "fix_adapt_neigh.h"

#include "adapt_smoothing.h"
#include "adapt_lists.h"
#include "argument.h"
#include "fix_sph_tm.h"
#include "pair_sph_tm.h"
#include "refinement.h"
#include "restart_block.h"

#include "atom.h"
#include "atom_masks.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "group.h"
#include "modify.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;
using namespace FixConst;

namespace {
// IDs and positions of owned particles, which may be newer where the loops run
struct PlacesOnHost {
  explicit PlacesOnHost(FixAdaptNeigh &fix) : tags(fix.body().loops()), places(fix.body().loops())
  {
    const size_t n = fix.host()->atom->nlocal;
    Backend &loops = fix.body().loops();
    tags.resize(n + 1);
    places.resize(3 * n + 1);
    loops.copy(tags.loop_write(), fix.pair().loop_tags(), n * sizeof(int));
    loops.copy(places.loop_write(), fix.body().state().x, 3 * n * sizeof(double));
    tag = tags.host_read();
    x = places.host_read();
  }
  LoopArray<int> tags;
  LoopArray<double> places;
  const int *tag;
  const double *x;
};
}    // namespace

static constexpr size_t MOST_STATE = 128;    // values of all parts in a restart file

namespace {
constexpr double LEAST_MOVE = 1e-6;    // of the spacing: a way that counts between runs
constexpr int RESTART_HEAD = 5;        // of the values of a particle in a restart file
}    // namespace

FixAdaptNeigh::FixAdaptNeigh(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  restart_global = 1;
  size_vector = 0;
  global_freq = 1;
  extvector = 0;
  nevery = 1;
  comm_forward = Cloud::MOST_COLUMNS;
  force_reneighbor = 1;
  next_reneighbor = -1;
  parts.push_back(std::make_unique<AdaptSmoothing>(*this));
  parts.push_back(std::make_unique<AdaptLists>(*this));
  parts.push_back(std::make_unique<Refinement>(*this));
  read_keywords(Keywords(lmp, "Fix adapt/neigh", narg - 3, arg + 3));
  for (const auto &p : parts)
    if (p->in_use()) used.push_back(p.get());
  for (const AdaptPart *p : used) size_vector += (int) p->outputs().size();
  if (!on_host()) datamask_read = datamask_modify = EMPTY_MASK;    // with Kokkos: the loops ask for what they need
  vector_flag = size_vector > 0;
  update_packed_size();
  for (const AdaptPart *p : used) has_values = has_values || p->has_values();
  create_attribute = restart_peratom = has_values;
  if (!has_values) return;
  for (AdaptPart *p : used) p->grow(atom->nmax);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

void FixAdaptNeigh::post_constructor()
{
  check_lengths();
  for (AdaptPart *p : used) p->ready();
}

FixAdaptNeigh::~FixAdaptNeigh()
{
  if (copymode || !has_values) return;
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
}

void FixAdaptNeigh::read_keywords(Keywords k)
{
  while (k.next()) {
    const bool known = std::any_of(parts.begin(), parts.end(), [&k](const auto &p) { return p->keyword(k); });
    if (!known) k.unknown(known_words());
  }
}

// keywords, then the options behind some of them
std::string FixAdaptNeigh::known_words() const
{
  std::string words, options;
  for (const auto &p : parts) {
    const std::vector<std::string> own = p->keywords(), behind = p->options();
    words += (words.empty() ? "" : ", ") + utils::join_words(own, ", ");
    if (!behind.empty()) options += "; options of " + own[0] + " are " + utils::join_words(behind, ", ");
  }
  return words + options;
}

int FixAdaptNeigh::setmask() { return PRE_EXCHANGE | POST_NEIGHBOR | PRE_FORCE | END_OF_STEP; }

void FixAdaptNeigh::init()
{
  sph = FixSPHTM::of(lmp, "Fix adapt/neigh");
  pair_sph = dynamic_cast<PairSPHTM *>(force->pair_match("^sph/tm", 0));
  if (!pair_sph) error->all(FLERR, "Fix adapt/neigh needs pair style sph/tm");
  if (modify->get_fix_by_style("^adapt/neigh").size() > 1)
    error->all(FLERR, "More than one fix adapt/neigh: write all its keywords in one");
  check_group();
  check_restart();
  for (AdaptPart *p : used) p->init();
}

void FixAdaptNeigh::check_group()
{
  if (atom->natoms > 0 && group->count(igroup) == 0 && comm->me == 0)
    error->warning(FLERR, "Fix adapt/neigh {}: there is no particle in its group {}", id, group->names[igroup]);
}

void FixAdaptNeigh::setup_pre_exchange()
{
  end_watch();
  if (!update->setupflag) begin_watch();    // of write_restart or write_data
  for (AdaptPart *p : used) p->setup_pre_exchange();
}
void FixAdaptNeigh::setup_pre_force(int)
{
  for (AdaptPart *p : used) p->setup_pre_force();
}
void FixAdaptNeigh::setup(int)
{
  for (AdaptPart *p : used) p->setup();
}
void FixAdaptNeigh::pre_exchange()
{
  forget_places();    // with 'run pre no' it is still on
  const auto timed = sph->run_clock.timed(this);
  for (AdaptPart *p : used) p->pre_exchange();
}
void FixAdaptNeigh::post_neighbor()
{
  const auto timed = sph->run_clock.timed(this);
  for (AdaptPart *p : used) p->post_neighbor();
}
void FixAdaptNeigh::pre_force(int)
{
  const auto timed = sph->run_clock.timed(this);
  for (AdaptPart *p : used) p->pre_force();
}
void FixAdaptNeigh::end_of_step()
{
  const auto timed = sph->run_clock.timed(this);
  for (AdaptPart *p : used) p->end_of_step();
}

bool FixAdaptNeigh::on_host() const
{
  for (const AdaptPart *p : used)
    if (p->on_host()) return true;
  return false;
}

void FixAdaptNeigh::renew_lists() { next_reneighbor = update->ntimestep + 1; }
void FixAdaptNeigh::post_run()
{
  if (!pair_sph) return;    // 'run pre no': it was not set up
  for (AdaptPart *p : used) p->post_run();
  begin_watch();
}

double FixAdaptNeigh::compute_vector(int n)
{
  FixSPHTM::current(lmp, sph, fmt::format("Fix adapt/neigh {}", id));
  for (AdaptPart *p : used) {
    const int of_part = (int) p->outputs().size();
    if (n < of_part) return p->output(n);
    n -= of_part;
  }
  return 0.0;
}

void *FixAdaptNeigh::extract(const char *what, int &dim)
{
  dim = 0;
  for (AdaptPart *p : used)
    if (void *found = p->extract(what)) return found;
  return nullptr;
}

bool FixAdaptNeigh::uses(const std::string &keyword) const
{
  for (const AdaptPart *p : used)
    for (const std::string &k : p->keywords())
      if (k == keyword) return true;
  return false;
}
void FixAdaptNeigh::remade(int i, double factor)
{
  for (AdaptPart *p : used) p->remade(i, factor);
}
void FixAdaptNeigh::neighborhood_changed(int i)
{
  for (AdaptPart *p : used) p->neighborhood_changed(i);
}

/* ---------------------------------------------------------------------- between runs

   delete_atoms and reset_atoms give particles other IDs, displace_atoms, change_box and set other places, and no style
   is told. Parts that know particles by them ask here. */

void FixAdaptNeigh::remember(int i, int tag, const double *x)
{
  if (i >= (int) then.tag.size()) {
    then.tag.resize(atom->nmax, 0);
    then.x.resize(3 * (size_t) atom->nmax, 0.0);
  }
  then.tag[i] = tag;
  std::copy_n(x, 3, &then.x[3 * (size_t) i]);
}

void FixAdaptNeigh::compare(int i, int tag, const double *x)
{
  if (i >= (int) then.tag.size() || then.tag[i] == 0) return;
  const double *was = &then.x[3 * (size_t) i];
  double dx = x[0] - was[0], dy = x[1] - was[1], dz = x[2] - was[2];
  domain->minimum_image(dx, dy, dz);
  then.renamed = then.renamed || tag != then.tag[i];
  then.moved = then.moved || dx * dx + dy * dy + dz * dz > then.least * then.least;
}

void FixAdaptNeigh::begin_watch()
{
  if (!has_values) return;
  then = {};
  then.on = true;
  then.least = LEAST_MOVE * pair_sph->settings_in_use().spacing;
  const PlacesOnHost now(*this);
  for (int i = 0; i < atom->nlocal; i++) remember(i, now.tag[i], now.x + 3 * (size_t) i);
}

void FixAdaptNeigh::end_watch()
{
  if (!has_values) return;
  if (then.on) {
    const PlacesOnHost now(*this);
    for (int i = 0; i < atom->nlocal; i++) compare(i, now.tag[i], now.x + 3 * (size_t) i);
  }
  const int mine[2] = {then.moved, then.renamed};
  int any[2];
  MPI_Allreduce(mine, any, 2, MPI_INT, MPI_MAX, world);
  then = {};
  if (any[0] || any[1])
    for (AdaptPart *p : used) p->changed(any[0], any[1]);
}

/* ---------------------------------------------------------------------- to ghosts */

void FixAdaptNeigh::forward(double *rows, int columns)
{
  forwarded = rows;
  forwarded_columns = columns;
  comm->forward_comm(this, columns);
}

int FixAdaptNeigh::pack_forward_comm(int n, int *list, double *buf, int pbc_flag, int *pbc)
{
  const double shift[3] = {domain->xprd, domain->yprd, domain->zprd};
  for (int k = 0; k < n; k++) {
    double *to = buf + (size_t) k * forwarded_columns;
    std::copy_n(forwarded + (size_t) list[k] * forwarded_columns, forwarded_columns, to);
    for (int d = 0; pbc_flag && d < 3; d++) to[d] += pbc[d] * shift[d];
    if (pbc_flag && domain->triclinic) {
      to[0] += pbc[5] * domain->xy + pbc[4] * domain->xz;
      to[1] += pbc[3] * domain->yz;
    }
  }
  return n * forwarded_columns;
}

void FixAdaptNeigh::unpack_forward_comm(int n, int first, double *buf)
{
  std::copy_n(buf, (size_t) n * forwarded_columns, forwarded + (size_t) first * forwarded_columns);
}

/* ---------------------------------------------------------------------- values of particles */

void FixAdaptNeigh::update_packed_size()
{
  maxexchange = 0;
  for (const AdaptPart *p : used) maxexchange += p->most_packed();
}

void FixAdaptNeigh::grow_arrays(int nmax)
{
  for (AdaptPart *p : used) p->grow(nmax);
}
void FixAdaptNeigh::copy_arrays(int from, int to, int)
{
  if (then.on && from < (int) then.tag.size()) {
    const double x[3] = {then.x[3 * (size_t) from], then.x[3 * (size_t) from + 1], then.x[3 * (size_t) from + 2]};
    remember(to, then.tag[from], x);
  }
  for (AdaptPart *p : used) p->copy(from, to);
}
void FixAdaptNeigh::set_arrays(int i)
{
  if (then.on) remember(i, 0, atom->x[i]);
  for (AdaptPart *p : used) p->set_new(i);
}
int FixAdaptNeigh::pack_exchange(int i, double *buf)
{
  if (then.on) compare(i, (int) atom->tag[i], atom->x[i]);
  int m = 0;
  for (AdaptPart *p : used) m += p->pack(i, buf + m);
  return m;
}
int FixAdaptNeigh::unpack_exchange(int i, double *buf)
{
  if (then.on) remember(i, (int) atom->tag[i], atom->x[i]);
  int m = 0;
  for (AdaptPart *p : used) m += p->unpack(i, buf + m);
  return m;
}
void FixAdaptNeigh::reorder_arrays(int n, const int *order)
{
  forget_places();
  for (AdaptPart *p : used) p->reorder(n, order);
}
void FixAdaptNeigh::send_arrays(int n, const int *sent, const int *filled_by, double *buf)
{
  forget_places();
  for (AdaptPart *p : used) p->send(n, sent, filled_by, buf);
}
void FixAdaptNeigh::receive_arrays(int n, const int *place, double *buf)
{
  forget_places();
  for (AdaptPart *p : used) p->receive(n, place, buf);
}
// number of values, ID and place that they belong to, values
int FixAdaptNeigh::pack_restart(int i, double *buf)
{
  buf[1] = (double) atom->tag[i];
  std::copy_n(atom->x[i], 3, buf + 2);
  const int m = RESTART_HEAD + pack_exchange(i, buf + RESTART_HEAD);
  buf[0] = m;
  return m;
}
// the values of this fix, the nth of those that the file has for owned particle i: their number, then they
const double *FixAdaptNeigh::restart_row(int i, int nth)
{
  const double *extra = atom->extra[i];
  int m = 0;
  for (int k = 0;; k++) {
    const int left = atom->nextra_store - m;
    if (left < 1 || !is_whole(extra[m], 1, left))
      error->one(FLERR, "Fix adapt/neigh: the {} is damaged: the values of particle {} have no proper length",
                 restart_file_name(lmp), atom->tag[i]);
    if (k == nth) return extra + m;
    m += (int) extra[m];
  }
}

// of what a restart file has for particles; LAMMPS's fixes, and those that parts add, believe them
void FixAdaptNeigh::check_lengths()
{
  const int fixes = atom->nextra_store ? modify->nfix_restart_peratom : 0;
  for (int i = 0; fixes && i < atom->nlocal; i++) restart_row(i, fixes - 1);
}

void FixAdaptNeigh::unpack_restart(int i, int nth)
{
  const double *row = restart_row(i, nth), *at = row + RESTART_HEAD;
  const double *end = row + (int) *row;
  for (AdaptPart *p : used) {
    std::string why;
    const int n = p->look(at, (int) (end - at), why);
    if (n < 0)
      error->one(FLERR, "Fix adapt/neigh: particle {} in the {} has {}: it is damaged, or was written with other "
                        "keywords; write the same ones", atom->tag[i], restart_file_name(lmp), why);
    at += n;
  }
  if (at > end || !is_whole(row[1], 1, MAXSMALLINT)) refuse_restart();
  if (at != end)
    error->one(FLERR, "Fix adapt/neigh: the {} was written with other keywords; write the same ones: particle {} has "
                      "{} values, {} expected", restart_file_name(lmp), atom->tag[i], (int) *row - 1, at - row - 1);
  then.on = false;
  unpack_exchange(i, const_cast<double *>(row) + RESTART_HEAD);
  const auto *of_pair = dynamic_cast<PairSPHTM *>(force->pair_match("^sph/tm", 0));
  then.least = of_pair ? LEAST_MOVE * of_pair->settings_in_use().spacing : 0.0;
  then.on = of_pair != nullptr;    // until the first set-up: commands may move and rename particles before
  if (then.on) remember(i, (int) row[1], row + 2);
  read.rows++;
  read.hash += hash_bytes(row, (int) *row * sizeof(double));
}

// LAMMPS writes as many values as this says
int FixAdaptNeigh::size_restart(int i)
{
  std::vector<double> values(maxexchange + RESTART_HEAD);
  return pack_restart(i, values.data());
}
int FixAdaptNeigh::maxsize_restart() { return RESTART_HEAD + maxexchange; }

// How many particles with what checksum; then of every part that is in use its place among all, the number of its
// values, and they. A block has room for MOST_STATE
void FixAdaptNeigh::write_restart(FILE *fp)
{
  if (then.on) {    // commands that came after the last run are told now: the file knows nothing of them
    end_watch();
    begin_watch();
  }
  std::vector<double> row(maxexchange + RESTART_HEAD), all;
  uint64_t mine[2] = {0, 0}, sum[2];
  for (int i = 0; has_values && i < atom->nlocal; i++) {
    const int n = pack_restart(i, row.data());
    mine[0]++;
    mine[1] += hash_bytes(row.data(), n * sizeof(double));
  }
  MPI_Reduce(mine, sum, 2, MPI_UINT64_T, MPI_SUM, 0, world);
  for (const uint64_t bits : sum) append_bits(all, bits);
  for (size_t k = 0; k < parts.size(); k++) {
    if (!parts[k]->in_use()) continue;
    const std::vector<double> s = parts[k]->state();
    all.insert(all.end(), {(double) k, (double) s.size()});
    all.insert(all.end(), s.begin(), s.end());
  }
  if (comm->me == 0) write_restart_block(fp, all);
}

void FixAdaptNeigh::restart(char *buf)
{
  const std::vector<double> all = read_restart_block(lmp, "Fix adapt/neigh", buf, 4, MOST_STATE);
  read.rows_written = take_bits(&all[0]);
  read.hash_written = take_bits(&all[2]);
  size_t at = 4;
  for (size_t k = 0; k < parts.size(); k++) {
    if (!parts[k]->in_use()) continue;
    const bool fits = at + 2 <= all.size() && all[at] == (double) k && is_whole(all[at + 1], 0, all.size() - at - 2);
    const size_t n = fits ? (size_t) all[at + 1] : 0;
    if (!fits || !parts[k]->restore(all.data() + at + 2, n)) refuse_restart();
    at += 2 + n;
  }
  if (at != all.size()) refuse_restart();
}

void FixAdaptNeigh::refuse_restart()
{
  error->all(FLERR, "Fix adapt/neigh: the {} was written with other keywords; write the same ones",
             restart_file_name(lmp));
}

// all rows that were written have been read, and are not what was written
void FixAdaptNeigh::check_restart()
{
  uint64_t mine[2] = {read.rows, read.hash}, all[2];
  MPI_Allreduce(mine, all, 2, MPI_UINT64_T, MPI_SUM, world);
  if (all[0] > 0 && all[0] == read.rows_written && all[1] != read.hash_written)
    error->all(FLERR, "Fix adapt/neigh: the {} is damaged: the values of its particles do not have the checksum "
                      "written with them", restart_file_name(lmp));
  read = {};
}

double FixAdaptNeigh::memory_usage()
{
  double sum = 0.0;
  for (const AdaptPart *p : used) sum += p->bytes();
  return sum;
}
