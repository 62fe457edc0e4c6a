#include "tool_particles.h"

#include "row_source.h"
#include "scene.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"

#include <algorithm>
#include <limits>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

void ToolParticles::live_in(LAMMPS *l, const Scene &s)
{
  lmp = l;
  scene = &s;
  loops = &s.state()->loops();
  heat.live_in(*loops);
  if (!untaken) untaken = (int *) loops->allocate_result(sizeof(int));
}

ToolParticles::~ToolParticles()
{
  if (untaken) loops->release_result(untaken);
}

// the way of all particles of a tool; of one that turns it is not asked for
static double way_of(const tm_pose &from, const tm_pose &to)
{
  const tm_mat3 &a = from.turn, &b = to.turn;
  const bool turns = a.xx != b.xx || a.xy != b.xy || a.xz != b.xz || a.yx != b.yx || a.yy != b.yy || a.yz != b.yz ||
                     a.zx != b.zx || a.zy != b.zy || a.zz != b.zz;
  return turns ? std::numeric_limits<double>::infinity() : tm_vec_norm(tm_vec_sub(to.shift, from.shift));
}

void ToolParticles::move(const tm_pose &from, const tm_pose &to) const
{
  scene->neighbor_check().of_tool(way_of(from, to));
  ContactLoops::of(*loops).move(*loops, lmp->atom->nlocal,
                                {scene->state()->arrays(), fix->groupbit, type, lmp->domain->dimension == 3, from, to},
                                0);
}

tm_real *ToolParticles::heat_of_contact()
{
  heat.resize(std::max(lmp->atom->nmax, 1));
  return heat.loop_write();
}

void ToolParticles::take_heat()
{
  const int n = lmp->atom->nlocal;
  const tm_rates_args &rates = scene->results().rate_args();
  const Settings &set = scene->model().settings_in_use();
  tm_spread_args a;
  RowSource *own = scene->adaptation().rows;
  a.rows = own ? own->others() : rates.rows;
  a.main = rates.rec.main;
  a.type = rates.type;
  a.body_type = type;
  a.kernel = set.kernel;
  a.h = set.h;
  a.heat = heat.loop_write();
  a.source = scene->state()->heat_source();
  ContactLoops::of(*loops).divide_heat(*loops, n, a, 0, untaken);
  untaken_of = n;
  lmp->comm->forward_comm(fix);
  a.heat = heat.loop_write();
  ContactLoops::of(*loops).collect_heat(*loops, n, a, 0);
}

void ToolParticles::check_heat()
{
  const int i = untaken_of ? *untaken : 0;
  if (i < untaken_of) {
    const tm_real *x = scene->results().host_records().main + (size_t) i * TM_REC;
    lmp->error->one(FLERR,
                    "Fix contact/tri {} particles: no particle of type {} near the contact at {:.6g} {:.6g} {:.6g} "
                    "takes up the friction heat; fill the tool with particles up to its surface",
                    fix->id, type, x[0], x[1], x[2]);
  }
  untaken_of = 0;
}

void ToolParticles::pack(int n, const int *list, double *buf)
{
  const double *lost = heat.host_read();
  for (int k = 0; k < n; k++) buf[k] = lost[list[k]];
}

void ToolParticles::unpack(int n, int first, const double *buf) { std::copy_n(buf, n, heat.host_write() + first); }

void ToolParticles::send(int n, const int *list, double *buf)
{
  ContactLoops::of(*loops).send_heat(*loops, n, {heat.loop_write(), list, buf}, 0);
}

void ToolParticles::receive(int n, int first, double *buf)
{
  ContactLoops::of(*loops).receive_heat(*loops, n, {heat.loop_write() + first, nullptr, buf}, 0);
}

}    // namespace SPHTM_NS
