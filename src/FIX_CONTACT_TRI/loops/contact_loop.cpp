#include "contact_loop.h"

namespace SPHTM_NS {

// effects as literals
template <unsigned FX> static tm_contact_result loop(int begin, int end, const tm_contact_args &args, unsigned)
{
  tm_contact_result sum = tm_contact_nothing();
  for (int i = begin; i < end; i++) {
    const tm_contact_result one = tm_contact_tri(i, &args, FX);
    if (one.depth > 0.0) tm_contact_sum(&sum, &one);
  }
  return sum;
}

// bits that few scenes ask for, and output steps: tested at run time
static tm_contact_result loop_any(int begin, int end, const tm_contact_args &args, unsigned fx)
{
  tm_contact_result sum = tm_contact_nothing();
  for (int i = begin; i < end; i++) {
    const tm_contact_result one = tm_contact_tri(i, &args, fx);
    if (one.depth > 0.0) tm_contact_sum(&sum, &one);
  }
  return sum;
}

tm_contact_result contact_loop(Backend &loops, int n, const tm_contact_args &args, unsigned fx)
{
  constexpr unsigned D = TM_CT_3D, H = TM_CT_HEAT, F = TM_CT_FRICTION;
  tm_contact_result (*part)(int, int, const tm_contact_args &, unsigned) = loop_any;
  if (fx == F) part = loop<F>;
  if (fx == (H | F)) part = loop<H | F>;
  if (fx == (D | F)) part = loop<D | F>;
  if (fx == (D | H | F)) part = loop<D | H | F>;
  // sums per triangle are not for several threads
  Backend &where = fx & TM_CT_OUTPUT ? Backend::host() : loops;
  return where.sum_blocks(
      n, tm_contact_nothing(), [&](int begin, int end) { return part(begin, end, args, fx); },
      [](tm_contact_result *a, const tm_contact_result *b) { tm_contact_sum(a, b); });
}

double contact_overlap(int n, const tm_contact_args &args, unsigned fx, tm_vec3 shift, int *worst)
{
  tm_touch touch[TM_TOUCH_MAX];
  double deepest = 0.0;
  *worst = -1;
  for (int i = 0; i < n; i++) {
    const tm_contact_law &w = args.law[args.type[i]];
    if (!w.active || !(args.mask[i] & args.group)) continue;
    const tm_vec3 x = tm_vec_sub(tm_load3(args.x + i * args.x_stride), shift);
    const tm_vec3 p = tm_pose_to_local(&args.pose, x);
    const int found = tm_touch_find(&args.mesh, &args.grid, p, w.radius, args.deep,
                                    (fx & TM_CT_TWO_SIDED) != 0, touch);
    for (int k = 0; k < found; k++)
      if (w.radius - touch[k].distance > deepest) {
        deepest = w.radius - touch[k].distance;
        *worst = i;
      }
  }
  return deepest;
}

}    // namespace SPHTM_NS
