/* Any bytes as a mesh file: read, build, index and ask it; nothing may crash, overflow or leak, and
   what is accepted must be finite and consistent. For clang's libFuzzer; see tools/fuzz.sh. */
#include <stdint.h>
#include <stdlib.h>

#include "tm_mesh_read.h"
#include "tm_touch.h"

static void require(int condition)
{
  if (!condition) abort();
}

static void check_mesh(const tm_mesh *m)
{
  require(m->nt > 0 && m->nv >= 3 && m->npatch >= 1 && m->npatch <= m->nt);
  for (int h = 0; h < 3 * m->nt; h++) {
    require(m->tri[h] >= 0 && m->tri[h] < m->nv);
    require(m->twin[h] >= -1 && m->twin[h] < 3 * m->nt && m->twin[h] != h);
  }
  for (int t = 0; t < m->nt; t++) {
    require(m->patch[t] >= 0 && m->patch[t] < m->npatch);
    require(m->area[t] > 0.0 && isfinite(m->area[t]));
    const double *n = m->normal + 3 * t;
    require(fabs(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] - 1.0) < 1e-9);
  }
  for (int i = 0; i < 3 * m->nv; i++)
    require(isfinite(m->vertex[i]) && isfinite(m->vertex_normal[i]));
  require(m->spoke_first[0] == 0 && m->spoke_first[m->nv] >= 0);
  for (int s = 0; s < m->spoke_first[m->nv]; s++) require(m->spoke[s] >= 0 && m->spoke[s] < m->nv);
}

/* Contact of particles on and around its vertices. */
static void touch(const tm_mesh *m)
{
  const tm_vec3 size = tm_vec_sub(tm_load3(m->hi), tm_load3(m->lo));
  const double reach = 0.05 * tm_vec_norm(size);
  tm_tri_grid grid;
  if (tm_tri_grid_build(&grid, m, reach, 20000.0) != TM_MESH_OK) return;
  const tm_tri_view view = tm_mesh_view(m);
  for (int k = 0; k < 200; k++) {
    const double *v = m->vertex + 3 * (k % m->nv);
    const double s = 0.3 * reach * (k / m->nv % 7 - 3);
    const tm_vec3 p = tm_vec(v[0] + s, v[1] - 0.5 * s, v[2] + 0.25 * s);
    tm_touch out[TM_TOUCH_MAX];
    const int n = tm_touch_find(&view, &grid.view, p, 0.5 * reach, reach, k % 2, tm_group_alone(), out);
    require(n >= 0 && n <= TM_TOUCH_MAX);
    for (int j = 0; j < n; j++) require(isfinite(out[j].distance) && isfinite(out[j].normal.x));
    tm_touch_find_f15(&view, &grid.view, p, 0.5 * reach, out);
  }
  tm_tri_grid_free(&grid);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  char msg[128];
  tm_soup soup;
  tm_mesh mesh;
  const int status = tm_mesh_read_buffer(data, size, &soup, msg, sizeof msg);
  require((status == TM_MESH_OK) == (soup.n > 0) && (status == TM_MESH_OK) == (msg[0] == '\0'));
  if (status != TM_MESH_OK) return 0;
  if (tm_mesh_build(&soup, NULL, &mesh, msg, sizeof msg) == TM_MESH_OK) {
    check_mesh(&mesh);
    if (mesh.nt < 2000) touch(&mesh);
    tm_mesh_free(&mesh);
  }
  tm_soup_free(&soup);
  return 0;
}
