/* Super time stepping RKL2: the stability polynomial, the order, a source, and conduction of a row of particles. */
#include "tm_conduct.h"
#include "ut.h"

#include <string.h>

/* one step of dy/dt = -lambda y + p in s stages, as tm_conduct_stage() takes it: F without the source */
static double step(double y, double lambda, double p, double dt, int s)
{
  double F = 0, older = 0, now = y;
  const double first = -lambda * y;
  for (int j = 1; j <= s; j++) {
    const tm_rkl c = tm_rkl_stage(j, s);
    const double power = -lambda * now, next = c.mu * F + c.nu * older + dt * (c.mu_t * power + c.gamma_t * first);
    older = F;
    F = next;
    now = y + F + tm_rkl_time(j, s) * dt * p;
  }
  return now;
}

static double legendre(int n, double x)
{
  double a = 1, b = x;
  if (n == 0) return 1;
  for (int k = 2; k <= n; k++) {
    const double c = ((2 * k - 1) * x * b - (k - 1) * a) / k;
    a = b;
    b = c;
  }
  return b;
}

static void check_polynomial(void)
{
  for (int s = 3; s <= 51; s += 2) {
    const double range = tm_rkl_range(s), b = tm_rkl_b(s);
    UT_TRUE(tm_rkl_stages(range) == s && tm_rkl_stages(range * (1 + 1e-9)) == s + 2);
    for (int k = 0; k <= 400; k++) {
      const double z = range * k / 400, R = step(1, z, 0, 1, s);
      UT_WITHIN(R, 1 - b + b * legendre(s, 1 - 2 * z / range), 1e-11);
      UT_TRUE(R > 0 && R <= 1 && (k == 0 || R < 1));
    }
    UT_TRUE(fabs(step(1, 2 * range, 0, 1, s)) > 1); /* beyond it, it grows */
  }
  UT_TRUE(tm_rkl_stages(0) == 3 && tm_rkl_stages(5) == 3 && tm_rkl_stages(5.01) == 5);
}

/* y' = -y + p to t = 1: second order, and the steady state is kept exactly */
static void check_order(void)
{
  for (int s = 3; s <= 15; s += 4) {
    double error[2];
    for (int k = 0; k < 2; k++) {
      const int n = 20 << k;
      double y = 3;
      for (int i = 0; i < n; i++) y = step(y, 1, 2, 1.0 / n, s);
      error[k] = fabs(y - (2 + exp(-1)));
    }
    UT_WITHIN(log2(error[0] / error[1]), 2, 0.1);
    UT_WITHIN(step(0.25, 8, 2, 1, 5), 0.25, 1e-14);
    for (int j = 1; j <= s; j++) { /* times of the stages */
      double c[3] = {0, 0, 0};
      for (int m = 1; m <= j; m++) {
        const tm_rkl q = tm_rkl_stage(m, s);
        c[2] = q.mu * c[1] + q.nu * c[0] + q.mu_t + q.gamma_t;
        c[0] = c[1];
        c[1] = c[2];
      }
      UT_WITHIN(c[2], tm_rkl_time(j, s), 1e-13);
    }
    UT_NEAR(tm_rkl_time(s, s), 1, 1e-15);
  }
}

/* A closed row of particles, spacing 1, in one dimension of a square lattice with one row: pairs that do not move. */
enum { N = 64, REACH = 2 };
static struct {
  tm_conduct_args a;
  tm_material material[3];
  int type[N], mask[N], index[N * 2 * REACH], number[N], none[N];
  ptrdiff_t first[N];
  double main[N * TM_REC], heat[N * TM_REC_HEAT], temp[N * 3], power_per_volume[N], source[N];
  int conducting[N * 2 * REACH], count[N];
  double g[N * 2 * REACH], capacity[N], power[N], at_first[N], F[N], older[N], T[2][N];
} w;

static void make(double k_left, double k_right)
{
  memset(&w, 0, sizeof w);
  tm_conduct_args *a = &w.a;
  for (int t = 1; t < 3; t++) {
    w.material[t].body = TM_BODY_HEAT;
    w.material[t].capacity.value = t;
    w.material[t].conductivity.value = t == 1 ? k_left : k_right;
  }
  for (int i = 0; i < N; i++) {
    w.type[i] = i < N / 2 ? 1 : 2;
    w.mask[i] = 1;
    double *r = w.main + i * TM_REC;
    r[TM_REC_X] = i;
    r[TM_REC_M] = i % 3 ? 1.0 : 1.1;
    r[TM_REC_RHO] = 1;
    w.temp[3 * i] = i < N / 2 ? 300 : 400;
    w.heat[i * TM_REC_HEAT + TM_REC_T] = w.temp[3 * i];
    w.heat[i * TM_REC_HEAT + TM_REC_K] = w.type[i] == 1 ? k_left : k_right;
    w.first[i] = 2 * REACH * i;
    for (int d = -REACH; d <= REACH; d++)
      if (d && i + d >= 0 && i + d < N) w.index[w.first[i] + w.number[i]++] = i + d;
  }
  tm_rates_args *q = &a->rates;
  q->rows.index = w.index;
  q->rows.first = w.first;
  q->rows.mechanical = w.none;
  q->rows.thermal = w.number;
  q->rows.stride = 1;
  q->rec.main = w.main;
  q->rec.heat = w.heat;
  q->h = 1.2;
  q->support_radius2 = 2.4 * 2.4;
  q->norm = tm_kernel_norm(TM_KERNEL_HYPERBOLIC, 2, 1.2);
  q->slope_norm = q->norm / 1.2;
  q->type = w.type;
  q->ntypes = 2;
  q->heat = w.power_per_volume;
  a->others = q->rows;
  a->state.field[TM_F_TEMP] = w.temp;
  a->state.material = w.material;
  a->state.type = w.type;
  a->state.mask = w.mask;
  a->source = w.source;
  a->rows.index = w.conducting;
  a->rows.count = w.count;
  a->rows.g = w.g;
  a->rows.width = 2 * REACH;
  a->capacity = w.capacity;
  a->power = w.power;
  a->first = w.at_first;
  a->F = w.F;
  a->older = w.older;
}

/* Heat of the row after a step; returns the number of stages. */
static int advance(double dt)
{
  tm_conduct_args *a = &w.a;
  double rate = 0;
  a->dt = dt;
  a->T_new = w.T[0];
  for (int i = 0; i < N; i++) {
    UT_TRUE(tm_conduct_room(i, a) == w.number[i]);
    rate = tm_max(rate, tm_conduct_row(i, a, 0));
  }
  const int s = tm_rkl_stages(rate * dt);
  for (int j = 1; j <= s; j++) {
    a->T = w.T[(j - 1) % 2];
    a->T_new = w.T[j % 2];
    a->stage = tm_rkl_stage(j, s);
    a->c = tm_rkl_time(j, s);
    a->is_first = j == 1;
    for (int i = 0; i < N; i++) tm_conduct_stage(i, a);
    double *const F = a->F;
    a->F = a->older;
    a->older = F;
  }
  a->T = w.T[s % 2];
  return s;
}

static void check_row(void)
{
  make(1, 100);
  int s = advance(1e-6); /* a step that is short: the stages are those of the explicit scheme */
  UT_TRUE(s == 3);
  for (int i = 0; i < N; i++)
    for (int k = 0; k < w.count[i]; k++) { /* conductances are symmetric to the last bit */
      const int j = w.conducting[4 * i + k];
      int found = 0;
      for (int m = 0; m < w.count[j]; m++)
        if (w.conducting[4 * j + m] == i) {
          found = 1;
          UT_TRUE(w.g[4 * j + m] == w.g[4 * i + k]);
        }
      UT_TRUE(found);
    }
  for (int run = 0; run < 3; run++) {
    const double dt[3] = {0.02, 1, 50};
    make(1, 100);
    w.source[5] = run == 1 ? 3.0 : 0.0;
    s = advance(dt[run]);
    double sum = 0, moved = 0, lowest = 1e300, highest = 0, in = 0;
    for (int i = 0; i < N; i++) {
      const tm_conduct_result r = tm_conduct_end(i, &w.a);
      const double heat = w.power_per_volume[i] * w.main[i * TM_REC + TM_REC_M] * dt[run];
      sum += heat;
      moved += fabs(heat);
      lowest = tm_min(lowest, r.lowest);
      highest = tm_max(highest, r.highest);
      in += w.capacity[i] * (w.a.T[i] - w.temp[3 * i]);
      UT_WITHIN(w.temp[3 * i] + (heat + dt[run] * w.source[i]) / w.capacity[i], w.a.T[i], 1e-10);
    }
    UT_TRUE(moved > 1);
    UT_WITHIN(sum, 0, 1e-13 * moved);
    UT_WITHIN(in, dt[run] * w.source[5], 1e-12 * moved);
    UT_TRUE(lowest > 299 && highest < 401);
    UT_TRUE(s > 2 && s < 700);
  }
  /* in many steps and in one of many stages: the same, and of second order */
  double T[3][N];
  for (int run = 0; run < 3; run++) {
    const int n = run == 0 ? 2000 : run == 1 ? 20 : 40;
    make(2, 5);
    for (int i = 0; i < N; i++) w.temp[3 * i] = 300 + 50 * sin(TM_PI * i / N) + 20 * cos(TM_PI * 3 * i / N);
    for (int k = 0; k < n; k++) {
      advance(40.0 / n);
      for (int i = 0; i < N; i++) w.temp[3 * i] = w.a.T[i];
    }
    for (int i = 0; i < N; i++) T[run][i] = w.temp[3 * i];
  }
  double worst[2] = {0, 0};
  for (int i = 0; i < N; i++)
    for (int k = 0; k < 2; k++) worst[k] = tm_max(worst[k], fabs(T[k + 1][i] - T[0][i]));
  UT_TRUE(worst[0] < 0.05 && worst[0] > 1e-8);
  UT_WITHIN(log2(worst[0] / worst[1]), 2, 0.3);

  /* particles of prescribed temperature: the steady profile between them is linear */
  make(1, 1);
  for (int i = 0; i < N; i++) w.main[i * TM_REC + TM_REC_M] = 1;
  for (int i = 0; i < N; i++) w.mask[i] = i < 4 ? 3 : i >= N - 4 ? 5 : 1;
  w.a.held.n = 2;
  w.a.held.group[0] = 2;
  w.a.held.group[1] = 4;
  w.a.held.temperature[0] = 500;
  w.a.held.temperature[1] = 300;
  for (int k = 0; k < 300; k++) {
    advance(500);
    for (int i = 0; i < N; i++) w.temp[3 * i] = w.a.T[i];
    UT_TRUE(w.a.T[0] == 500 && w.a.T[N - 1] == 300);
  }
  for (int i = 8; i < N - 8; i++) UT_WITHIN(2 * w.temp[3 * i] - w.temp[3 * i - 3] - w.temp[3 * i + 3], 0, 0.02);
}

int main(void)
{
  check_polynomial();
  check_order();
  check_row();
  return ut_summary();
}
