#include "triangle_values.h"

namespace SPHTM_NS {

void TriangleValues::live_in(Backend &b)
{
  loops = &b;
  for (auto *a : {&tri_force, &tri_heat}) a->live_in(b);
  tri_count.live_in(b);
}

void TriangleValues::clear(size_t triangles)
{
  auto zero = [&](auto &array, size_t n) {
    array.resize(n);
    loops->zero(array.loop_write(), array.bytes());
  };
  zero(tri_force, 3 * triangles);
  zero(tri_heat, triangles);
  zero(tri_count, triangles);
}

void TriangleValues::hand_to(tm_contact_args &a)
{
  a.tri_force = tri_force.loop_write();
  a.tri_heat = tri_heat.loop_write();
  a.tri_count = tri_count.loop_write();
}

void TriangleValues::sum_over_ranks(MPI_Comm world, double power_unit)
{
  int me;
  MPI_Comm_rank(world, &me);
  auto reduce = [&](void *data, size_t n, MPI_Datatype type) {
    MPI_Reduce(me ? data : MPI_IN_PLACE, data, (int) n, type, MPI_SUM, 0, world);
  };
  double *heat = tri_heat.host_write();
  reduce(tri_force.host_write(), tri_force.size(), MPI_DOUBLE);
  reduce(heat, tri_heat.size(), MPI_DOUBLE);
  reduce(tri_count.host_write(), tri_count.size(), MPI_INT);
  const double power = 1.0 / power_unit;
  for (size_t t = 0; t < tri_heat.size(); t++) heat[t] *= power;
}

}    // namespace SPHTM_NS
