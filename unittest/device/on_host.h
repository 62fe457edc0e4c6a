/* SPH-TM: the host's half of the test that compares a GPU with the host. */
#ifndef ON_HOST_H
#define ON_HOST_H

#include "cloud.h"

#ifdef __cplusplus
extern "C" {
#endif

void points_on_host(int which, int n, int n_in, int n_out, const double *in, const tm_material *m, double *out, double *scale);
void cloud_make(cloud *w, int dim, int kernel, double ratio, unsigned effects, tm_mesh *mesh, tm_tri_grid *grid);
void cloud_on_host(int stage, cloud *w);
void rows_on_host(cloud *w);
void random_fill(double *p, ptrdiff_t n, double lo, double hi);
int points_not_built(void);    /* meshes that could not be */

#ifdef __cplusplus
}
#endif

#endif
