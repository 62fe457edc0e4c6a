#include "tm_split_pattern.h"

#include <stddef.h>

static const struct {
  const char *name;
  int dim, center, corners;
} kinds[TM_SPLIT_KINDS] = {
    {"square", 2, 0, 4}, {"hexagon", 2, 1, 6}, {"cube", 3, 0, 8}, {"cube/centre", 3, 1, 8}, {"icosahedron", 3, 1, 12}};

const char *tm_split_name(int kind) { return kind >= 0 && kind < TM_SPLIT_KINDS ? kinds[kind].name : NULL; }
int tm_split_dim(int kind) { return kind >= 0 && kind < TM_SPLIT_KINDS ? kinds[kind].dim : 0; }

/* ---------------------------------------------------------------------- overlap of two kernels */

/* Gauss-Legendre nodes and weights on [-1, 1], by Newton's method on the Legendre polynomial */
enum { NODES = 32 };
static void gauss(double *x, double *w)
{
  for (int i = 0; i < NODES; i++) {
    double z = cos(TM_PI * (i + 0.75) / (NODES + 0.5)), slope = 1.0;
    for (int turn = 0; turn < 60; turn++) {
      double p0 = 1.0, p1 = z;
      for (int n = 2; n <= NODES; n++) {
        const double p2 = ((2 * n - 1) * z * p1 - (n - 1) * p0) / n;
        p0 = p1;
        p1 = p2;
      }
      slope = NODES * (z * p1 - p0) / (z * z - 1.0);
      const double step = p1 / slope;
      z -= step;
      if (fabs(step) < 1e-15) break;
    }
    x[i] = z;
    w[i] = 2.0 / ((1.0 - z * z) * slope * slope);
  }
}

/* Sorts the n cuts and drops those outside of [lo, hi]; both ends are added. Returns the new n. */
static int panels(double *cut, int n, double lo, double hi)
{
  int m = 0;
  for (int i = 0; i < n; i++)
    if (cut[i] > lo && cut[i] < hi) cut[m++] = cut[i];
  cut[m++] = lo;
  cut[m++] = hi;
  for (int i = 1; i < m; i++)
    for (int j = i; j > 0 && cut[j] < cut[j - 1]; j--) {
      const double t = cut[j];
      cut[j] = cut[j - 1];
      cut[j - 1] = t;
    }
  return m;
}

typedef struct {
  int kernel, dim;
  double alpha, d;
  double x[NODES], w[NODES];
} overlap;

/* seen from the center of the circle of radius r: how far along it the distance is s */
static double angle(double s, double r, double d)
{
  return 2.0 * asin(sqrt(tm_min((s - fabs(r - d)) * (s + fabs(r - d)) / (4.0 * r * d), 1.0)));
}

/* Mean of shape(s/alpha) over the circle or sphere of radius r whose center is d away. */
static double mean_on_shell(const overlap *o, double r)
{
  const double d = o->d, a = o->alpha;
  if (d == 0.0 || r == 0.0) return tm_kernel_shape(o->kernel, (r + d) / a);
  /* distances s from |d-r| to d+r; pieces end where the kernel has a knot (integer q) */
  double cut[8];
  const double lo = fabs(d - r), hi = d + r;
  if (lo >= tm_kernel_support(o->kernel) * a) return 0.0;
  for (int k = 0; k < 3; k++) cut[k] = (k + 1) * a;
  int n = panels(cut, 3, lo, hi);
  double sum = 0.0;
  for (int p = 0; p + 1 < n; p++) {
    if (o->dim == 3) { /* the share of a shell with distance s is s ds/(2 r d) */
      const double mid = 0.5 * (cut[p] + cut[p + 1]), half = 0.5 * (cut[p + 1] - cut[p]);
      for (int i = 0; i < NODES; i++) {
        const double s = mid + half * o->x[i];
        sum += half * o->w[i] * s * tm_kernel_shape(o->kernel, s / a) / (2.0 * r * d);
      }
      continue;
    }
    /* 2D: over the angle, s^2 = r^2 + d^2 - 2 r d cos(angle); mid - half cos(u) takes square roots off the ends */
    const double t0 = p == 0 ? 0.0 : angle(cut[p], r, d), t1 = p + 2 == n ? TM_PI : angle(cut[p + 1], r, d);
    const double mid = 0.5 * (t0 + t1), half = 0.5 * (t1 - t0);
    for (int side = 0; side < 2; side++)
      for (int i = 0; i < NODES; i++) {
        const double u = 0.25 * TM_PI * (o->x[i] + 1.0 + 2.0 * side), t = mid - half * cos(u);
        const double h = sin(0.5 * t), s = sqrt((r - d) * (r - d) + 4.0 * r * d * h * h);
        sum += 0.25 * o->w[i] * half * sin(u) * tm_kernel_shape(o->kernel, s / a);
      }
  }
  return sum;
}

double tm_kernel_overlap(int kernel, int dim, double alpha, double d)
{
  overlap o = {.kernel = kernel, .dim = dim, .alpha = alpha, .d = d};
  gauss(o.x, o.w);
  const double support = tm_kernel_support(kernel);
  /* pieces in r: knots of the first kernel, and radii at which the circle touches one of the second */
  double cut[16];
  int n = 0;
  for (int k = 1; k <= 3; k++) {
    cut[n++] = k;
    cut[n++] = fabs(d - k * alpha);
    cut[n++] = d + k * alpha;
  }
  cut[n++] = d;
  n = panels(cut, n, 0.0, support);
  double sum = 0.0;
  for (int p = 0; p + 1 < n; p++) {
    /* r = mid - half cos(t) takes the square roots off the ends of the pieces */
    const double mid = 0.5 * (cut[p] + cut[p + 1]), half = 0.5 * (cut[p + 1] - cut[p]);
    for (int side = 0; side < 2; side++)
      for (int i = 0; i < NODES; i++) {
        const double t = 0.25 * TM_PI * (o.x[i] + 1.0 + 2.0 * side);
        const double r = mid - half * cos(t);
        const double area = dim == 3 ? 4.0 * TM_PI * r * r : 2.0 * TM_PI * r;
        sum += 0.25 * TM_PI * o.w[i] * half * sin(t) * area * tm_kernel_shape(kernel, r) * mean_on_shell(&o, r);
      }
  }
  return sum * tm_kernel_norm(kernel, dim, 1.0) * tm_kernel_norm(kernel, dim, alpha);
}

/* ---------------------------------------------------------------------- places and masses */

static void places(tm_split_pattern *p)
{
  const int first = kinds[p->kind].center, corners = kinds[p->kind].corners;
  p->n = first + corners;
  for (int k = 0; k < p->n; k++) p->x[k][0] = p->x[k][1] = p->x[k][2] = 0.0;
  const double e = p->epsilon, golden = 0.5 * (1.0 + sqrt(5.0));
  for (int k = 0; k < corners; k++) {
    double *x = p->x[first + k];
    if (p->kind == TM_SPLIT_HEXAGON) {
      x[0] = e * cos(TM_PI * k / 3.0);
      x[1] = e * sin(TM_PI * k / 3.0);
    } else if (p->kind == TM_SPLIT_ICOSAHEDRON) { /* (0, +-1, +-golden) and its rotations */
      const double unit = e / sqrt(1.0 + golden * golden);
      const int axis = k / 4;
      x[(axis + 1) % 3] = (k & 1 ? unit : -unit);
      x[(axis + 2) % 3] = (k & 2 ? unit : -unit) * golden;
    } else
      for (int c = 0; c < p->dim; c++) x[c] = (k >> c & 1 ? 0.5 : -0.5) * e;
  }
}

/* Solves the symmetric positive definite a y = b for two right hand sides; 0 when it is not. */
static int solve(int n, double a[TM_SPLIT_MOST][TM_SPLIT_MOST], double *b, double *c)
{
  for (int i = 0; i < n; i++) { /* Cholesky's factor in the lower half */
    for (int j = 0; j <= i; j++) {
      double s = a[i][j];
      for (int k = 0; k < j; k++) s -= a[i][k] * a[j][k];
      if (i > j) a[i][j] = s / a[j][j];
      else if (s > 1e-12 * a[i][i]) a[i][i] = sqrt(s);
      else return 0;
    }
  }
  for (int i = 0; i < n; i++) {
    for (int k = 0; k < i; k++) {
      b[i] -= a[i][k] * b[k];
      c[i] -= a[i][k] * c[k];
    }
    b[i] /= a[i][i];
    c[i] /= a[i][i];
  }
  for (int i = n - 1; i >= 0; i--) {
    for (int k = i + 1; k < n; k++) {
      b[i] -= a[k][i] * b[k];
      c[i] -= a[k][i] * c[k];
    }
    b[i] /= a[i][i];
    c[i] /= a[i][i];
  }
  return 1;
}

int tm_split_make(int kind, int kernel, double epsilon, double alpha, tm_split_pattern *p)
{
  if (kind < 0 || kind >= TM_SPLIT_KINDS || kernel < 0 || kernel >= TM_KERNEL_COUNT || !(epsilon > 0.0) ||
      !(alpha > 0.0) || !(epsilon < 1e3) || !(alpha < 1e3))
    return TM_SPLIT_BAD_INPUT;
  p->kind = kind;
  p->dim = kinds[kind].dim;
  p->epsilon = epsilon;
  p->alpha = alpha;
  places(p);

  const int n = p->n;
  double a[TM_SPLIT_MOST][TM_SPLIT_MOST], a0[TM_SPLIT_MOST][TM_SPLIT_MOST];
  double b[TM_SPLIT_MOST], b0[TM_SPLIT_MOST], one[TM_SPLIT_MOST];
  /* two kernels of alpha h are those of h, alpha times as large and alpha^-dim as high */
  const double scale = p->dim == 3 ? 1.0 / (alpha * alpha * alpha) : 1.0 / (alpha * alpha);
  for (int r = 0; r < n; r++) {
    for (int s = 0; s <= r; s++) {
      double d2 = 0.0;
      for (int c = 0; c < 3; c++) d2 += (p->x[r][c] - p->x[s][c]) * (p->x[r][c] - p->x[s][c]);
      a[r][s] = a[s][r] = a0[r][s] = a0[s][r] =
          scale * tm_kernel_overlap(kernel, p->dim, 1.0, sqrt(d2) / alpha); /* A, S13 (8) */
    }
    double d2 = 0.0;
    for (int c = 0; c < 3; c++) d2 += p->x[r][c] * p->x[r][c];
    b[r] = b0[r] = tm_kernel_overlap(kernel, p->dim, alpha, sqrt(d2)); /* b, S13 (8) */
    one[r] = 1.0;
  }
  if (!solve(n, a, b, one)) return TM_SPLIT_SINGULAR;
  double sum_b = 0.0, sum_one = 0.0;
  for (int r = 0; r < n; r++) {
    sum_b += b[r];
    sum_one += one[r];
  }
  const double mu = (1.0 - sum_b) / sum_one, c = tm_kernel_overlap(kernel, p->dim, 1.0, 0.0);
  double value = c, least = 1.0;
  for (int r = 0; r < n; r++) {
    p->mass[r] = b[r] + mu * one[r]; /* S13 (9) with sum 1: A lambda = b + mu 1 */
    least = tm_min(least, p->mass[r]);
  }
  for (int r = 0; r < n; r++) { /* S13 (8) */
    value -= 2.0 * p->mass[r] * b0[r];
    for (int s = 0; s < n; s++) value += p->mass[r] * a0[r][s] * p->mass[s];
  }
  p->error = sqrt(tm_max(value, 0.0) / c);
  return least > TM_SPLIT_LEAST ? TM_SPLIT_OK : TM_SPLIT_NEGATIVE;
}
