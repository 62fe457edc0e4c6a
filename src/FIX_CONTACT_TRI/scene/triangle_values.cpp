#include "triangle_values.h"

namespace SPHTM_NS {

void TriangleValues::live_in(Backend &b)
{
  loops = &b;
  for (auto *a : {&tri_force, &tri_heat}) a->live_in(b);
  tri_count.live_in(b);
}

void TriangleValues::hand_to(tm_contact_args &a, size_t triangles)
{
  auto zeros = [&](auto &array, size_t n) {
    array.resize(n);
    loops->zero(array.loop_write(), array.bytes());
    return array.loop_write();
  };
  a.tri_force = zeros(tri_force, 3 * triangles);
  a.tri_heat = zeros(tri_heat, triangles);
  a.tri_count = zeros(tri_count, triangles);
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
