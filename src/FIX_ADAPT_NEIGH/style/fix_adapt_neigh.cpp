/* SPH-TM: fix adapt/neigh. See doc/fix_adapt_neigh.rst. */
#include "fix_adapt_neigh.h"

#include "adapt_lists.h"
#include "adapt_smoothing.h"
#include "argument.h"
#include "refinement.h"

#include "atom.h"
#include "atom_masks.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "group.h"
#include "modify.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;
using namespace FixConst;

FixAdaptNeigh::FixAdaptNeigh(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg), parts(lmp, *this), between(parts)
{
  restart_global = 1;
  size_vector = 0;
  global_freq = 1;
  extvector = 0;
  nevery = 1;
  comm_forward = Cloud::MOST_COLUMNS;
  force_reneighbor = 1;
  next_reneighbor = -1;
  parts.add(std::make_unique<AdaptSmoothing>(parts));
  parts.add(std::make_unique<AdaptLists>(parts));
  parts.add(std::make_unique<Refinement>(parts));
  parts.read(Keywords(lmp, "Fix adapt/neigh", narg - 3, arg + 3));
  for (const AdaptPart *p : parts.used()) size_vector += (int) p->outputs().size();
  if (!parts.on_host()) datamask_read = datamask_modify = EMPTY_MASK;    // with Kokkos: loops ask for theirs
  vector_flag = size_vector > 0;
  parts.update_packed_size();
  parts.offer();
  create_attribute = restart_peratom = !parts.values().empty();
  if (parts.values().empty()) return;
  grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

void FixAdaptNeigh::post_constructor()
{
  check_lengths();
  for (AdaptPart *p : parts.used()) p->ready();
}

FixAdaptNeigh::~FixAdaptNeigh()
{
  if (copymode) return;
  parts.scene().set_adaptation({});
  for (Fix *f : modify->get_fix_by_style("^adapt/neigh"))    // a second one, which the next run refuses
    if (f != this) static_cast<FixAdaptNeigh *>(f)->parts.offer();
  if (parts.values().empty()) return;
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
}

int FixAdaptNeigh::setmask() { return PRE_EXCHANGE | PRE_FORCE | END_OF_STEP; }

void FixAdaptNeigh::init()
{
  parts.find_run();
  if (atom->natoms > 0 && group->count(igroup) == 0 && comm->me == 0)
    error->warning(FLERR, "Fix adapt/neigh {}: there is no particle in its group {}", id, group->names[igroup]);
  check_restart();
  for (AdaptPart *p : parts.used()) p->init();
}

void FixAdaptNeigh::setup_pre_exchange()
{
  between.end();
  if (!update->setupflag) between.begin();    // of write_restart or write_data
  for (AdaptPart *p : parts.used()) p->setup_pre_exchange();
}
void FixAdaptNeigh::setup_pre_force(int)
{
  for (AdaptPart *p : parts.used()) p->setup_pre_force();
}
void FixAdaptNeigh::setup(int)
{
  for (AdaptPart *p : parts.used()) p->setup();
}
void FixAdaptNeigh::pre_exchange()
{
  between.stop();    // with 'run pre no' it is still on
  const auto timed = parts.state().clock().timed_rarely(this);
  for (AdaptPart *p : parts.used()) p->pre_exchange();
}
void FixAdaptNeigh::pre_force(int)
{
  const auto timed = parts.state().clock().timed(this);
  for (AdaptPart *p : parts.used()) p->pre_force();
}
void FixAdaptNeigh::end_of_step()
{
  const auto timed = parts.state().clock().timed(this);
  for (AdaptPart *p : parts.used()) p->end_of_step();
}
void FixAdaptNeigh::post_run()
{
  if (!parts.known()) return;    // 'run pre no': it was not set up
  for (AdaptPart *p : parts.used()) p->post_run();
  between.begin();
}

double FixAdaptNeigh::compute_vector(int n)
{
  parts.scene().check_current(parts.known(), fmt::format("Fix adapt/neigh {}", id));
  for (AdaptPart *p : parts.used()) {
    const int of_part = (int) p->outputs().size();
    if (n < of_part) return p->output(n);
    n -= of_part;
  }
  return 0.0;
}

double FixAdaptNeigh::memory_usage()
{
  double sum = 0.0;
  for (const AdaptPart *p : parts.used()) sum += p->bytes();
  return sum;
}

/* ---------------------------------------------------------------------- to ghosts */

int FixAdaptNeigh::pack_forward_comm(int n, int *list, double *buf, int pbc_flag, int *pbc)
{
  const int columns = parts.forwarded_columns();
  const double shift[3] = {domain->xprd, domain->yprd, domain->zprd};
  for (int k = 0; k < n; k++) {
    double *to = buf + (size_t) k * columns;
    std::copy_n(parts.forwarded() + (size_t) list[k] * columns, columns, to);
    for (int d = 0; pbc_flag && d < 3; d++) to[d] += pbc[d] * shift[d];
    if (pbc_flag && domain->triclinic) {
      to[0] += pbc[5] * domain->xy + pbc[4] * domain->xz;
      to[1] += pbc[3] * domain->yz;
    }
  }
  return n * columns;
}

void FixAdaptNeigh::unpack_forward_comm(int n, int first, double *buf)
{
  const int columns = parts.forwarded_columns();
  std::copy_n(buf, (size_t) n * columns, parts.forwarded() + (size_t) first * columns);
}

/* ---------------------------------------------------------------------- values of particles */

void FixAdaptNeigh::grow_arrays(int nmax)
{
  for (ParticleValues *v : parts.values()) v->grow(nmax);
}
void FixAdaptNeigh::copy_arrays(int from, int to, int)
{
  between.copy(from, to);
  for (ParticleValues *v : parts.values()) v->copy(from, to);
}
void FixAdaptNeigh::set_arrays(int i)
{
  between.set_new(i);
  for (ParticleValues *v : parts.values()) v->set_new(i);
}
int FixAdaptNeigh::pack_exchange(int i, double *buf)
{
  between.leave(i);
  int m = 0;
  for (ParticleValues *v : parts.values()) m += v->pack(i, buf + m);
  return m;
}
int FixAdaptNeigh::unpack_exchange(int i, double *buf)
{
  between.arrive(i);
  int m = 0;
  for (ParticleValues *v : parts.values()) m += v->unpack(i, buf + m);
  return m;
}
void FixAdaptNeigh::reorder_arrays(int n, const int *order)
{
  between.stop();
  for (ParticleValues *v : parts.values()) v->reorder(n, order);
}
void FixAdaptNeigh::send_arrays(int n, const int *sent, const int *filled_by, double *buf)
{
  between.stop();
  for (ParticleValues *v : parts.values()) v->send(n, sent, filled_by, buf);
}
void FixAdaptNeigh::receive_arrays(int n, const int *index, double *buf)
{
  between.stop();
  for (ParticleValues *v : parts.values()) v->receive(n, index, buf);
}
