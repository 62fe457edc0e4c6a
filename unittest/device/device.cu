/* The physics headers on a GPU against the host.
   Prints a line for each case: name, values compared, largest difference over what is allowed, ok or FAILED. Exits with 77
   where there is no GPU. Both halves are compiled from the same headers, the host's as C (on_host.c). */
#define TM_BLOCK 1    /* arrays are those of the host */
#include "on_host.h"

#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

constexpr int POINTS = 200000;
int failed = 0;

void check(cudaError_t status)
{
  if (status == cudaSuccess) return;
  printf("%s\n", cudaGetErrorString(status));
  exit(1);
}

template <class T> struct OnDevice {
  T *p = nullptr;
  OnDevice(const T *from, size_t n)
  {
    check(cudaMalloc(&p, n * sizeof(T)));
    check(cudaMemcpy(p, from, n * sizeof(T), cudaMemcpyHostToDevice));
  }
  ~OnDevice() { cudaFree(p); }
};
template <class T> void bring(std::vector<T> &to, const OnDevice<T> &from)
{
  check(cudaGetLastError());
  check(cudaMemcpy(to.data(), from.p, to.size() * sizeof(T), cudaMemcpyDeviceToHost));
}
int blocks(int n) { return (n + 127) / 128; }

// the largest difference over what is allowed; a value that is no number on one side only is worse than any
struct Worst {
  double value = 0.0;
  long count = 0;
  void take(double device, double host, double allowed)
  {
    count++;
    if (isnan(device) && isnan(host)) return;
    const double apart = fabs(device - host);
    if (device == host) return;
    if (!(apart <= 1e300) || !(allowed > 0.0)) value = INFINITY;
    else value = fmax(value, apart / allowed);
  }
  void print(const char *group, const char *name)
  {
    const bool ok = value <= 1.0 && count > 0;
    failed += !ok;
    printf("%s %s %ld %.3g %s\n", group, name, count, value, ok ? "ok" : "FAILED");
  }
};

/* ---------------------------------------------------------------------- point functions */

__global__ void run_points(int which, int n, int n_in, int n_out, const double *in, const tm_material *m, double *out)
{
  const int i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i < n) point_run(which, in + (ptrdiff_t) i * n_in, m, out + (ptrdiff_t) i * n_out);
}

struct Range {
  double lo, hi;
};
// the last range holds for the inputs that follow
const std::vector<Range> ranges[POINTS_CASES] = {
    {{-1, 1}},                                                                          // products
    {{1, 4}, {1, 4}, {1, 4}, {1, 4}, {-300, 300}},                                      // pair_numbers
    {{0, 3.2}},                                                                         // kernels
    {{-1, 1}},                                                                          // eigen
    {{-1, 1}},                                                                          // positive_part
    {{-1, 1}},                                                                          // inverse
    {{-300, 300}},                                                                      // jaumann
    {{0, 1}, {-5, 15}, {280, 1800}},                                                    // flow_stress
    {{-9e8, 9e8}, {-9e8, 9e8}, {-9e8, 9e8}, {-9e8, 9e8}, {-9e8, 9e8}, {-9e8, 9e8}, {0, 1}, {280, 1700}, {-25, -10}},
    {{6500, 11000}, {-1e5, 1e6}},                                                       // eos
    {{250, 1700}, {250, 1700}, {0.5, 2}, {0.1, 3}, {0.1, 2}, {0.01, 1e4}, {-1e4, 1e4}}, // conduction
    {{-1e9, 1e9}, {0, 1e9}, {-5, 15}, {280, 1800}, {0, 0.1}},                           // damage
    {{0.1, 2}, {0.1, 2}, {-9, 9}, {0.1, 4}, {30, 60}, {0.5, 2}, {-1, 1}},               // artificial
    {{0.1, 2}, {0.1, 2}, {-0.5, 0.5}, {-1, 1}, {-1, 1}, {-1, 1}, {-1, 1}, {0, 9}, {0, 9}, {-1, 5}},
    {{-1, 1}},                                                                          // closest
    {{-1, 1}},                                                                          // motion
};

void compare_points(int which, const char *name, int n_in, int n_out, double tolerance)
{
  tm_material material[POINTS_MATERIALS];
  for (int k = 0; k < POINTS_MATERIALS; k++) points_material(k, material + k);
  std::vector<double> in((size_t) POINTS * n_in), host((size_t) POINTS * n_out, 0.0), device(host), scale(POINTS);
  for (size_t k = 0; k < in.size(); k++) {
    const auto &r = ranges[which];
    const Range range = r[k % n_in < r.size() ? k % n_in : r.size() - 1];
    random_fill(&in[k], 1, range.lo, range.hi);
  }
  points_on_host(which, POINTS, n_in, n_out, in.data(), material, host.data(), scale.data());
  const OnDevice<double> d_in(in.data(), in.size()), d_out(device.data(), device.size());
  const OnDevice<tm_material> d_material(material, POINTS_MATERIALS);
  run_points<<<blocks(POINTS), 128>>>(which, POINTS, n_in, n_out, d_in.p, d_material.p, d_out.p);
  bring(device, d_out);
  Worst worst;
  for (size_t k = 0; k < host.size(); k++)
    worst.take(device[k], host[k], tolerance * fmax(fabs(host[k]), scale[k / n_out]));
  worst.print("point", name);
}

/* ---------------------------------------------------------------------- particle functions */

__global__ void run_cloud(int stage, cloud *w)
{
  const int i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i < w->n) cloud_run(stage, i, w);
}

__global__ void count_rows(cloud *w)
{
  const int i = blockIdx.x * blockDim.x + threadIdx.x;
  const tm_row_args a = cloud_row_args(w);
  if (i < w->n) tm_row_count(i, &a);
}
__global__ void place_rows(cloud *w)
{
  const tm_row_args a = cloud_row_args(w);
  ptrdiff_t at = 0;
  for (int s = 0; s * TM_ROW_SLICE < w->n; s++) {
    for (int i = s * TM_ROW_SLICE; i < w->n && i < (s + 1) * TM_ROW_SLICE; i++) w->first[i] = at + i % TM_ROW_SLICE;
    at += tm_row_slice_size(s, w->n, &a);
  }
  w->slice = TM_ROW_SLICE;
}
// rows are filled by one thread each, or by a warp each
__global__ void fill_rows(cloud *w)
{
  const int i = blockIdx.x * blockDim.x + threadIdx.x;
  const tm_row_args a = cloud_row_args(w);
  if (i < w->n) tm_row_fill(i, &a);
}
__global__ void fill_rows_by_warps(cloud *w)
{
  __shared__ tm_row_entry entry[ROOM];
  const int i = blockIdx.x;
  const tm_row_args a = cloud_row_args(w);
  for (int k = threadIdx.x; k < w->length[i]; k += 32) entry[k] = tm_row_load(i, k, &a);
  __syncwarp();
  for (int k = threadIdx.x; k < w->length[i]; k += 32) tm_row_put(i, k, w->length[i], entry, &a);
}

void compare_rows(const cloud *host, const char *name, bool by_warps)
{
  const OnDevice<cloud> device(host, 1);
  std::vector<cloud> back(1);
  count_rows<<<blocks(host->n), 128>>>(device.p);
  place_rows<<<1, 1>>>(device.p);
  if (by_warps) fill_rows_by_warps<<<host->n, 32>>>(device.p);
  else fill_rows<<<blocks(host->n), 128>>>(device.p);
  bring(back, device);
  const cloud &w = back[0];
  Worst worst;
  for (int i = 0; i < host->n; i++) {
    int length = 0;
    for (int s = 0; s < TM_SEGMENTS; s++) {
      worst.take(w.count[s][i], host->count[s][i], 0.5);
      length += host->count[s][i];
    }
    for (int k = 0; k < length; k++)
      worst.take(w.index[w.first[i] + k * w.slice], host->index[host->first[i] + k * host->slice], 0.5);
  }
  worst.print(name, by_warps ? "rows_by_warps" : "rows");
}

// each stage from the host's state before it
void compare_stage(cloud *host, const tm_tri_view &d_mesh, const tm_grid_view &d_grid, const char *group, int stage,
                   const char *name, double tolerance)
{
  const tm_tri_view mesh = host->mesh;
  const tm_grid_view grid = host->grid;
  host->mesh = d_mesh;
  host->grid = d_grid;
  const OnDevice<cloud> device(host, 1);
  host->mesh = mesh;
  host->grid = grid;
  const std::vector<cloud> before(host, host + 1);
  cloud_on_host(stage, host);
  std::vector<cloud> back(1);
  run_cloud<<<blocks(host->n), 128>>>(stage, device.p);
  bring(back, device);
  Worst worst;
  long changed = 0;
  auto column = [&](const double *d, const double *h, int columns, int c) {
    double scale = 0.0;
    for (int i = 0; i < host->n; i++) scale = fmax(scale, fabs(h[(ptrdiff_t) i * columns + c]));
    for (int i = 0; i < host->n; i++)
      worst.take(d[(ptrdiff_t) i * columns + c], h[(ptrdiff_t) i * columns + c], tolerance * scale);
  };
#define COMPARE(array, columns)                                                      \
  for (int c = 0; c < columns; c++) column(back[0].array, host->array, columns, c); \
  for (int k = 0; k < columns * host->n; k++) changed += host->array[k] != before[0].array[k];
  CLOUD_ARRAYS(COMPARE)
  if (!changed) worst.value = INFINITY;    // a stage that does nothing tests nothing
  worst.print(group, name);
}

void compare_cloud(const char *group, int dim, int kernel, double ratio, unsigned effects)
{
  std::vector<cloud> made(1);
  cloud *w = made.data();
  tm_mesh mesh;
  tm_tri_grid grid;
  cloud_make(w, dim, kernel, ratio, effects, &mesh, &grid);
  compare_rows(w, group, false);
  compare_rows(w, group, true);

  tm_tri_view m = w->mesh;
  tm_grid_view g = w->grid;
  const int spokes = m.spoke_first[m.nv], table = g.blocks[0] * g.blocks[1] * g.blocks[2];
  const int cells = grid.nblocks * TM_GRID_CELLS + 1, segments = g.first[cells - 1] + 1;
  const OnDevice<double> vertex(m.vertex, 3 * m.nv), corner(m.corner, 9 * m.nt), normal(m.normal, 3 * m.nt),
      ball(m.ball, 4 * m.nt), edge_normal(m.edge_normal, 9 * m.nt), vertex_normal(m.vertex_normal, 3 * m.nv);
  const OnDevice<int> tri(m.tri, 3 * m.nt), twin(m.twin, 3 * m.nt), patch(m.patch, m.nt),
      spoke_first(m.spoke_first, m.nv + 1), spoke(m.spoke, spokes), block(g.block, table), first(g.first, cells),
      segment(g.segment, segments), list(g.list, grid.entries);
  const OnDevice<float> near(g.near, grid.entries);
  m.vertex = vertex.p; m.corner = corner.p; m.normal = normal.p; m.ball = ball.p;
  m.edge_normal = edge_normal.p; m.vertex_normal = vertex_normal.p;
  m.tri = tri.p; m.twin = twin.p; m.patch = patch.p; m.spoke_first = spoke_first.p; m.spoke = spoke.p;
  g.block = block.p; g.first = first.p; g.segment = segment.p; g.list = list.p; g.near = near.p;
#define COMPARE_STAGE(name, tolerance) compare_stage(w, m, g, group, STAGE_##name, #name, tolerance);
  CLOUD_STAGES(COMPARE_STAGE)
  tm_tri_grid_free(&grid);
  tm_mesh_free(&mesh);
}

}    // namespace

int main()
{
  int devices = 0;
  if (cudaGetDeviceCount(&devices) != cudaSuccess || devices == 0) {
    printf("skipped: no GPU here\n");
    return 77;
  }
#define COMPARE_POINTS(name, n_in, n_out, tolerance) compare_points(POINT_##name, #name, n_in, n_out, tolerance);
  POINT_CASES(COMPARE_POINTS)

  const unsigned basic = TM_FX_VISCOSITY | TM_FX_ARTSTRESS | TM_FX_CONDUCTION | TM_FX_HEAT | TM_FX_PLASTICITY | TM_FX_BODIES |
      TM_FX_HOURGLASS;
  const unsigned more = TM_FX_BALSARA | TM_FX_XSPH | TM_FX_SURFACE | TM_FX_DAMAGE | TM_FX_ENERGY | TM_FX_LEDGER;
  compare_cloud("3d", 3, TM_KERNEL_HYPERBOLIC, 1.2, basic);
  const unsigned stable = TM_FX_VISCOSITY | TM_FX_CONDUCTION | TM_FX_HEAT | TM_FX_PLASTICITY | TM_FX_HOURGLASS |
      TM_FX_CORRECTION | TM_FX_ONE_PASS | TM_FX_EXPANSION | TM_FX_COMPRESSION_HEAT | TM_FX_ARTIFICIAL_HEAT;
  compare_cloud("3d_default", 3, TM_KERNEL_HYPERBOLIC, 1.2, stable);
  compare_cloud("2d_default", 2, TM_KERNEL_WENDLAND_C4, 1.6, stable | TM_FX_BALSARA | TM_FX_LEDGER);
  compare_cloud("2d_faces", 2, TM_KERNEL_HYPERBOLIC, 1.2, stable | TM_FX_FACES);
  compare_cloud("3d_faces", 3, TM_KERNEL_HYPERBOLIC, 1.2, stable | TM_FX_FACES | TM_FX_SMOOTHING);
  compare_cloud("3d_every_effect", 3, TM_KERNEL_WENDLAND_C4, 1.2, basic | more | TM_FX_CORRECTION);
  compare_cloud("2d_plane_stress_f14", 2, TM_KERNEL_QUINTIC, 1.1, basic | more | TM_FX_FORM_F14 | TM_FX_PLANE_STRESS);
  compare_cloud("3d_sizes", 3, TM_KERNEL_HYPERBOLIC, 1.2, basic | more | TM_FX_CORRECTION | TM_FX_SMOOTHING);
  compare_cloud("2d_sizes", 2, TM_KERNEL_WENDLAND_C2, 1.2, basic | TM_FX_SMOOTHING);
  compare_cloud("2d_cubic", 2, TM_KERNEL_CUBIC, 1.3, basic | TM_FX_CORRECTION);
  compare_cloud("2d_wendland_c2", 2, TM_KERNEL_WENDLAND_C2, 1.3, TM_FX_HEAT | TM_FX_CONDUCTION | TM_FX_HOURGLASS);
  failed += points_not_built();
  printf("%s\n", failed ? "FAILED" : "all ok");
  return failed != 0;
}
