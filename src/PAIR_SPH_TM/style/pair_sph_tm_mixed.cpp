/* SPH-TM: pair style sph/tm, pair arithmetic in single. See tm_single.h. */
#include "pair_sph_tm.h"

#include "fix_sph_tm.h"
#include "tm_single.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "neighbor.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

static double position_unit(double reach, double skin, double spacing)
{
  return tm_single_position_unit(reach + skin, spacing);
}

void PairSPHTM::check_mixed() const
{
  if (!loops.has_single(backend, set.kernel))
    error->all(FLERR, "Pair style sph/tm precision mixed on a GPU is for the kernel hyperbolic alone; write 'precision "
                      "double', or that kernel");
  double far = 0.0;
  for (int d = 0; d < domain->dimension; d++)
    far = std::max({far, fabs(domain->boxlo[d]), fabs(domain->boxhi[d])});
  const double reach = tm_kernel_support(set.kernel) * list_h;
  const double farthest = tm_single_farthest(position_unit(reach, neighbor->skin, set.spacing)) * set.spacing;
  if (far > farthest)
    error->all(FLERR, "Pair style sph/tm precision mixed: the box reaches {:.3g} from the origin, and beyond {:.3g} "
                      "positions are too coarse for spacing {:.3g}; move the origin into the box", far, farthest,
               set.spacing);
}

tm_records_single PairSPHTM::single_records()
{
  const bool mixed = fix->has(TM_FX_MIXED), more = fix->has(TM_FX_ARTSTRESS) || fix->has(TM_FX_CONDUCTION);
  const size_t all = (size_t) atom->nlocal + atom->nghost + 1;
  single_main.make_room(mixed, all * TM_REC);
  single_more.make_room(mixed && more, all * TM_MORE);
  single_correction.make_room(mixed && fix->has(TM_FX_CORRECTION), all * TM_REC_CORRECTION);
  single_size.make_room(mixed && fix->has(TM_FX_SMOOTHING), all * TM_REC_SIZE);
  tm_records_single s = {};
  s.main = single_main.loop_write();
  s.more = single_more.loop_write();
  s.correction = single_correction.loop_write();
  s.size = single_size.loop_write();
  s.length = set.spacing;
  s.volume = pow(set.spacing, domain->dimension);
  s.position = position_unit(tm_kernel_support(set.kernel) * list_h, neighbor->skin, set.spacing);
  return s;
}

void PairSPHTM::round_records()
{
  const auto timed = fix->run_clock.timed(SPHTM_NS::RunClock::RATES);
  const tm_single_args a = {args.rec, args.single};
  loops.round_to_single(backend, atom->nlocal + atom->nghost, a, fix->effects());
}
