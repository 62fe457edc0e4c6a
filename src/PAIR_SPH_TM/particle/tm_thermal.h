/* SPH-TM: heat between one particle and the neighbors that are no mechanical ones; they also close
   its free surface.

   F15's NeibTherm: particles of a tool, or of another body. F15 (6) as it stands is perfect
   contact. A finite interface conductance hc of the type pair acts in series with the two halves
   of the particle distance, so that what leaves one side arrives at the other. */
#ifndef TM_THERMAL_H
#define TM_THERMAL_H

#include "tm_chunk.h"
#include "tm_group.h"
#include "tm_heat.h"
#include "tm_tensor.h"

#if TM_SINGLE
#error "double only: pairs that exchange heat alone have the precision of the state"
#endif

/* Heat power into particle i per volume and, with a surface, the sum that closes it, in *normal. On a GPU by several threads. */
TM_FN tm_real tm_thermal_sum(int i, tm_group group, const tm_rates_args *a, unsigned effects, tm_vec3 *normal)
{
  const int kernel = tm_fx_kernel(effects), dim3 = (effects & TM_FX_3D) != 0;
  const ptrdiff_t begin = a->rows.mechanical[i], end = begin + a->rows.thermal[i];
  const int *row = a->rows.index + a->rows.first[i];
  const tm_real *ri = tm_main_record(&a->rec, i);
  const tm_real *hi = tm_heat_record(&a->rec, i);
  const int sizes = (effects & TM_FX_SMOOTHING) != 0;
  const tm_pair_size of_all = tm_size_of_all(a, 1.0, 1.0);
  const tm_pair_size own = tm_own_size(sizes ? a->rec.size + (ptrdiff_t) i * TM_REC_SIZE : NULL, of_all);
  tm_pair_size p = of_all;
  tm_vec3 n = tm_vec(0, 0, 0);
  tm_real heat = 0.0;
  for (ptrdiff_t k = begin + group.lane; k < end; k += group.size) {
    const int j = row[k * a->rows.stride];
    const tm_real *rj = tm_main_record(&a->rec, j), *hj = tm_heat_record(&a->rec, j);
    const tm_real dx = ri[0] - rj[0], dy = ri[1] - rj[1], dz = dim3 ? ri[tm_part(2)] - rj[tm_part(2)] : 0.0;
    const tm_real r2 = dx * dx + dy * dy + dz * dz;
    if (sizes) {
      const tm_real *z = a->rec.size + j * TM_REC_SIZE;
      p = tm_pair_of_sizes(&own, z[TM_SIZE_INV_H], z[TM_SIZE_FACTOR], 1.0, a->norm_of_one, dim3);
    }
    if (sizes ? r2 * p.inv_h * p.inv_h >= a->support2 : r2 >= a->support_radius2) continue;
    const tm_real r = tm_pair_root(r2), mj = rj[tm_part(TM_REC_M)], rhoj = rj[tm_part(TM_REC_RHO)];
    const tm_real g = p.slope_norm * tm_kernel_slope(kernel, r * p.inv_h) * tm_pair_inverse(r);
    if (effects & TM_FX_SURFACE) n = tm_vec_axpy(n, mj / rhoj * g, tm_vec(dx, dy, dz));
    const tm_real hc = a->conductance ? a->conductance[a->type[i] * (a->ntypes + 1) + a->type[j]] : 0.0;
    heat += hc > 0.0 ? tm_conduction_pair_interface(hi[TM_REC_K], hj[TM_REC_K], hi[TM_REC_T], hj[TM_REC_T], mj / rhoj,
                                                    g, r, hc)
                     : tm_conduction_pair(hi[TM_REC_K], hj[TM_REC_K], hi[TM_REC_T], hj[TM_REC_T], mj, rhoj, g);
  }
  heat = tm_group_sum_real(heat, group);
  if (effects & TM_FX_SURFACE)
    n = tm_vec(tm_group_sum_real(n.x, group), tm_group_sum_real(n.y, group), tm_group_sum_real(n.z, group));
  *normal = n;
  return heat;
}

TM_FN void tm_thermal(int i, tm_group group, const tm_rates_args *a, unsigned effects)
{
  tm_vec3 n;
  const tm_real heat = tm_thermal_sum(i, group, a, effects, &n);
  if (group.lane > 0) return;
  a->heat[i] += heat;
  if (effects & TM_FX_SURFACE) {
    a->surface[3 * (ptrdiff_t) i] += n.x;
    a->surface[3 * (ptrdiff_t) i + 1] += n.y;
    a->surface[3 * (ptrdiff_t) i + 2] += n.z;
  }
}

#endif
