/* SPH-TM: where a particle touches the tool, looked for when its force is due or earlier in the step. */
#ifndef TM_CONTACT_PLACES_H
#define TM_CONTACT_PLACES_H

#include "tm_contact_args.h"
#include "tm_contact_layer.h"
#include "tm_contact_sums.h"
#include "tm_record.h"

/* Diameter of particle i. */
TM_FN tm_real tm_contact_size(int i, const tm_contact_args *a)
{
  return a->size ? a->size[(ptrdiff_t) i * TM_REC_SIZE + TM_SIZE_DP] : 2.0 * a->law[a->type[i]].radius;
}

/* Where particle i touches the tool, or is near enough for a layer to reach it; the number of places. On a GPU several threads
   look, and all of them get the places. */
TM_FN int tm_contact_places(int i, tm_group group, const tm_contact_args *a, unsigned effects, tm_touch *touch)
{
  if (a->mask && !(a->mask[i] & a->group)) return 0;
  const tm_contact_law *w = a->law + a->type[i];
  if (!w->active) return 0;
  const tm_real radius = 0.5 * tm_contact_size(i, a), reach = a->layer && w->layer ? TM_LAYER_REACH : 1.0;
  const tm_vec3 p = tm_pose_to_local(&a->pose, tm_load3(a->x + i * a->x_stride));
  if (effects & TM_CT_F15) return tm_touch_find_f15(&a->mesh, &a->grid, p, radius, touch);
  return tm_touch_find(&a->mesh, &a->grid, p, reach * radius, a->deep, (effects & TM_CT_TWO_SIDED) != 0, group, touch);
}

/* The same, left in `found` for later in the step. */
TM_FN void tm_contact_look(int i, tm_group group, const tm_contact_args *a, unsigned effects)
{
  const tm_contact_found *found = &a->found;
  tm_touch touch[TM_TOUCH_MAX];
  const int n = tm_contact_places(i, group, a, effects, touch);
  if (group.lane > 0) return;
  int place = 0;
  if (n > 0) {
    const int first = tm_contact_take(found->taken, n);
    place = first <= found->room - n ? first * TM_FOUND + n : -1;
    if (place > 0)
      for (int k = 0; k < n; k++) found->touch[first + k] = touch[k];
  }
  found->place[i] = place;
}

/* What such a look has found, or finds now. */
TM_FN int tm_contact_found_places(int i, tm_group group, const tm_contact_args *a, unsigned effects, tm_touch *touch)
{
  const int place = a->found.place ? a->found.place[i] : -1;
  if (place < 0) return tm_contact_places(i, group, a, effects, touch);
  const int n = place % TM_FOUND;
  for (int k = 0; k < n; k++) touch[k] = a->found.touch[place / TM_FOUND + k];
  return n;
}

#endif
