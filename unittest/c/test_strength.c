/* Flow stresses against values worked out apart and against each other where one law becomes another, Jaumann rate
   against the closed simple shear and against the matrix product, radial return against the flow stress. */
#include "tm_strength.h"
#include "ut.h"

static tm_material johnson_cook(double a, double b, double n, double c, double m, double t_ref,
                                double t_melt, double rho, double cp)
{
  tm_material x = {0};
  x.strength = TM_STRENGTH_JOHNSON_COOK;
  x.shear = 7.9e10;
  x.rho0 = rho;
  x.capacity.value = cp;
  x.taylor_quinney = 0.9;
  x.jc_a = a * 1e6; x.jc_b = b * 1e6; x.jc_n = n; x.jc_c = c; x.jc_m = m;
  x.t_ref = t_ref; x.t_melt = t_melt; x.jc_rate0 = 1;
  return x;
}

/* dT/deps = chi Y/(rho cp) from Tref to eps = 1, with eps = u^4 against the pole of the slope */
static double adiabatic_temperature(const tm_material *m, double rate)
{
  const int steps = 400;
  const double du = 1.0 / steps, k = m->taylor_quinney / (m->rho0 * m->capacity.value);
  double T = m->t_ref;
  for (int i = 0; i < steps; i++) {
    double f[4];
    for (int j = 0; j < 4; j++) {
      const double u = (i + (j == 0 ? 0.0 : j == 3 ? 1.0 : 0.5)) * du;
      const double t = j == 0 ? T : T + (j == 3 ? 1.0 : 0.5) * du * f[j - 1];
      f[j] = k * tm_flow_stress(m, u * u * u * u, rate, t) * 4 * u * u * u;
    }
    T += du / 6 * (f[0] + 2 * f[1] + 2 * f[2] + f[3]);
  }
  return T;
}

static void check_table(const tm_material *m, const double y[5], double t_end)
{
  const double T = m->t_ref, end = adiabatic_temperature(m, 1e3);
  UT_WITHIN(tm_flow_stress(m, 0.1, 1, T) * 1e-6, y[0], 6e-4);
  UT_WITHIN(tm_flow_stress(m, 0.5, 1e3, T) * 1e-6, y[1], 6e-4);
  UT_WITHIN(tm_flow_stress(m, 0.5, 1e3, T + 300) * 1e-6, y[2], 6e-4);
  UT_WITHIN(tm_flow_stress(m, 1, 1e5, T + 500) * 1e-6, y[3], 6e-4);
  UT_WITHIN(end, t_end, 6e-3);
  UT_WITHIN(tm_flow_stress(m, 1, 1e3, end) * 1e-6, y[4], 6e-3);
}

static void check_limits(const tm_material *m)
{
  const double y0 = tm_flow_stress(m, 0, 1, m->t_ref);
  UT_NEAR(y0, m->jc_a, 1e-14);                                     /* 0^n with n < 1 */
  UT_NEAR(tm_flow_stress(m, -1e-9, 1, m->t_ref), y0, 1e-14);
  UT_NEAR(tm_flow_stress(m, 0, 1e-9, m->t_ref), y0, 1e-14);        /* slower than the reference */
  UT_NEAR(tm_flow_stress(m, 0, 0, m->t_ref), y0, 1e-14);
  UT_NEAR(tm_flow_stress(m, 0, 1, m->t_ref - 200), y0, 1e-14);     /* colder than the reference */
  UT_TRUE(tm_flow_stress(m, 1, 1e5, m->t_melt) == 0);              /* melted */
  UT_TRUE(tm_flow_stress(m, 1, 1e5, m->t_melt + 1000) == 0);
  UT_TRUE(tm_flow_stress(m, 1, 1e5, m->t_melt - 1) > 0);
}

static tm_sym3 random_deviator(double size)
{
  return tm_sym_deviator(tm_sym(ut_random(-size, size), ut_random(-size, size),
                                ut_random(-size, size), ut_random(-size, size),
                                ut_random(-size, size), ut_random(-size, size)));
}
static tm_mat3 full(tm_sym3 s)
{
  tm_mat3 m;
  m.xx = s.xx; m.xy = m.yx = s.xy; m.xz = m.zx = s.xz;
  m.yy = s.yy; m.yz = m.zy = s.yz; m.zz = s.zz;
  return m;
}
static double distance(tm_sym3 a, tm_sym3 b)
{
  const tm_sym3 d = tm_sym_axpy(a, -1, b);
  return sqrt(tm_sym_ddot(d, d));
}

/* s12 = G sin(gamma), s11 = -s22 = G (1 - cos(gamma)); Runge-Kutta in gamma */
static void check_simple_shear(void)
{
  const double G = 3.5, step = 1e-3;
  tm_mat3 L = tm_mat_scale(0, tm_mat_identity());
  L.xy = 1;
  tm_sym3 s = tm_sym(0, 0, 0, 0, 0, 0);
  for (int i = 1; i <= 5000; i++) {
    const tm_sym3 a = tm_jaumann_rate(s, L, G);
    const tm_sym3 b = tm_jaumann_rate(tm_sym_axpy(s, step / 2, a), L, G);
    const tm_sym3 c = tm_jaumann_rate(tm_sym_axpy(s, step / 2, b), L, G);
    const tm_sym3 d = tm_jaumann_rate(tm_sym_axpy(s, step, c), L, G);
    s = tm_sym_axpy(tm_sym_axpy(s, step / 6, a), step / 3, b);
    s = tm_sym_axpy(tm_sym_axpy(s, step / 3, c), step / 6, d);
    if (i % 500) continue;
    const double g = i * step;
    UT_WITHIN(s.xy, G * sin(g), 1e-10);
    UT_WITHIN(s.xx, G * (1 - cos(g)), 1e-10);
    UT_WITHIN(s.yy, -G * (1 - cos(g)), 1e-10);
    UT_WITHIN(s.zz, 0, 1e-14);
  }
}

/* 2G dev(D) + W S - S W as matrices */
static void check_jaumann_products(void)
{
  tm_mat3 L, W;
  tm_real *l = &L.xx, *w = &W.xx;
  for (int k = 0; k < 9; k++) l[k] = ut_random(-1, 1);
  for (int r = 0; r < 3; r++)
    for (int c = 0; c < 3; c++) w[3 * r + c] = 0.5 * (l[3 * r + c] - l[3 * c + r]);
  const tm_sym3 s = random_deviator(1), rate = tm_jaumann_rate(s, L, 2.5);
  const tm_mat3 ws = tm_mat_mul(W, full(s)), sw = tm_mat_mul(full(s), W), f = full(rate);
  const tm_mat3 d = full(tm_sym_deviator(tm_mat_symmetric(L)));
  for (int k = 0; k < 9; k++)
    UT_WITHIN((&f.xx)[k], 5 * (&d.xx)[k] + (&ws.xx)[k] - (&sw.xx)[k], 1e-14);
  UT_WITHIN(tm_sym_trace(rate), 0, 1e-14);
}

static int most_iterations;
static long sum_iterations, returns;

/* on the surface of the end of the step, on the line to the origin, 3G d = trial - Y */
static void check_return(const tm_material *m, tm_sym3 trial, double eps, double T, double dt)
{
  const tm_return_result r = tm_radial_return(m, trial, eps, T, dt);
  const double q = tm_sym_mises(trial), y0 = tm_flow_stress(m, eps, 0, T);
  const double y1 = tm_flow_stress(m, eps + r.d_eps, r.d_eps / dt, T), mises = tm_sym_mises(r.s);
  if (q <= y0) {
    UT_TRUE(r.d_eps == 0 && distance(r.s, trial) == 0);
    UT_NEAR(r.yield, y0, 1e-14);
    return;
  }
  UT_TRUE(r.d_eps > 0);
  UT_WITHIN(mises, y1, 1e-10 * y1 + 2e-15 * q);
  UT_WITHIN(r.yield, mises, 1e-13 * q);
  UT_WITHIN(3 * m->shear * r.d_eps, q - mises, 1e-13 * q);
  UT_WITHIN(distance(r.s, tm_sym_scale(mises / q, trial)), 0, 1e-13 * q);
  if (r.iterations > most_iterations) most_iterations = r.iterations;
  sum_iterations += r.iterations;
  returns++;
}

static void check_returns(tm_material m)
{
  for (int k = 0; k < 4000; k++) {
    const double eps = k % 5 ? pow(10, ut_random(-8, 0.5)) : 0, dt = pow(10, ut_random(-12, 0));
    const double T = ut_random(m.t_ref - 100, m.t_melt + 100);
    const double size = tm_flow_stress(&m, eps, 0, T) * pow(10, ut_random(-0.5, 0.5)) + 1;
    m.jc_c = k % 3 ? 0.02 : 0;
    m.jc_n = k % 7 ? ut_random(0.05, 1.5) : 1;
    check_return(&m, random_deviator(size * (k % 11 ? 0.4 : 40)), eps, T, dt);
  }
  /* eps = 0 and a small n: the increment is about 1e-65 */
  m.jc_c = 0;
  m.jc_n = 0.02;
  const tm_sym3 shear = tm_sym(0, 0, 0, 1.05 * m.jc_a / sqrt(3.0), 0, 0);
  check_return(&m, tm_sym_scale(tm_flow_stress(&m, 1e-65, 0, 0) / (1.05 * m.jc_a), shear), 0, 0, 1);
  /* a step of cutting: trial just outside, 1e4..1e6 per second */
  most_iterations = 0;
  sum_iterations = returns = 0;
  m.jc_c = 0.0134;
  m.jc_n = 0.234;
  for (int k = 0; k < 4000; k++) {
    const double eps = ut_random(0, 2), dt = 1e-9, T = ut_random(300, 1000);
    const double d = dt * pow(10, ut_random(3, 6)), y = tm_flow_stress(&m, eps + d, d / dt, T);
    const tm_sym3 s = random_deviator(1);
    check_return(&m, tm_sym_scale((y + 3 * m.shear * d) / tm_sym_mises(s), s), eps, T, dt);
  }
  printf("radial return: %.1f evaluations in a cutting step, %d at most\n",
         (double) sum_iterations / returns, most_iterations);
  UT_TRUE(returns == 4000 && most_iterations <= 8);
}

/* the series behind Johnson-Cook's return, against the functions of the library */
static void check_steps(void)
{
  double worst = 0.0;
  for (double n = 0.0; n <= 1.01; n += 0.1)
    for (double z = 1e-12; z <= TM_CLOSE; z *= 1.7) {
      const double power = expm1(n * log1p(z));
      worst = fmax(worst, fabs(tm_power_step(z, n) - power) / fmax(power, z));
      worst = fmax(worst, fabs(tm_log_step(z) / log1p(z) - 1.0));
      worst = fmax(worst, fabs(tm_log_step(-z) / log1p(-z) - 1.0));
    }
  UT_TRUE(worst < 1e-15);
  UT_TRUE(fabs(tm_log_step(20.0 * TM_CLOSE) / log1p(20.0 * TM_CLOSE) - 1.0) > 1e-12); /* beyond, they end too early */
}

static void check_other_kinds(void)
{
  tm_material m = {0};
  m.shear = 8e10;
  m.strength = TM_STRENGTH_PLASTIC;
  m.yield = 350e6;
  m.hardening = 1e9;
  UT_NEAR(tm_flow_stress(&m, 0.1, 7, 300), 450e6, 1e-14);
  for (int k = 0; k < 500; k++) {
    const tm_sym3 s = random_deviator(5e8);
    const double eps = ut_random(0, 0.5), q = tm_sym_mises(s), y = 350e6 + 1e9 * eps;
    const tm_return_result r = tm_radial_return(&m, s, eps, 300, 1e-9);
    UT_NEAR(r.d_eps, q > y ? (q - y) / (3 * 8e10 + 1e9) : 0, 1e-13);      /* F14 (12) */
    UT_NEAR(tm_sym_mises(r.s), q > y ? y + 1e9 * r.d_eps : q, 1e-13);     /* F14 (13), (14) */
    UT_TRUE(r.iterations == 0);
  }
  const tm_sym3 big = random_deviator(1e12);
  m.strength = TM_STRENGTH_ELASTIC;
  const tm_return_result elastic = tm_radial_return(&m, big, 0, 300, 1e-9);
  UT_TRUE(distance(elastic.s, big) == 0 && elastic.d_eps == 0 && elastic.yield == 0);
  UT_TRUE(tm_flow_stress(&m, 0, 0, 300) > 1e200);
  m.strength = TM_STRENGTH_NONE;
  UT_TRUE(tm_sym_mises(tm_radial_return(&m, big, 0, 300, 1e-9).s) == 0);
  m.shear = 0;
  UT_TRUE(tm_radial_return(&m, big, 0, 300, 1e-9).d_eps == 0);
}

/* softening exponents for these tests */
static tm_material johnson_cook_tanh(void)
{
  tm_material x = johnson_cook(800, 500, 0.3, 0.02, 0.9, 300, 1900, 4430, 526);
  x.strength = TM_STRENGTH_JOHNSON_COOK_TANH;
  x.tanh_a = 1.6; x.tanh_b = 0.4; x.tanh_d = 1.0; x.tanh_r = 6.0; x.tanh_s = 1.0;
  return x;
}

/* the formula written out, strain > 0 */
static double tanh_formula(const tm_material *m, double eps, double rate, double T)
{
  const double D = 1 - pow(T / m->t_melt, m->tanh_d), S = pow(T / m->t_melt, m->tanh_b);
  const double hot = (T - m->t_ref) / (m->t_melt - m->t_ref);
  return (m->jc_a + m->jc_b * pow(eps, m->jc_n) / exp(pow(eps, m->tanh_a))) * (1 + m->jc_c * log(rate / m->jc_rate0)) *
      (1 - pow(hot, m->jc_m)) * (D + (1 - D) * pow(tanh(1 / pow(eps + S, m->tanh_r)), m->tanh_s));
}

static void check_tanh(void)
{
  tm_material m = johnson_cook_tanh();
  for (int k = 0; k < 300; k++) {
    const double eps = ut_random(1e-3, 3), rate = pow(10, ut_random(0, 6)), T = ut_random(301, 1800);
    m.tanh_s = k % 3 ? 1.0 : ut_random(0.01, 2);    /* Calamaz; Sima and Ozel */
    UT_NEAR(tm_flow_stress(&m, eps, rate, T), tanh_formula(&m, eps, rate, T), 1e-12);
  }
  /* without its two factors it is Johnson-Cook */
  m.tanh_a = m.tanh_s = 0.0;
  tm_material jc = m;
  jc.strength = TM_STRENGTH_JOHNSON_COOK;
  for (int k = 0; k < 300; k++) {
    const double eps = k % 10 ? ut_random(0, 3) : 0, rate = pow(10, ut_random(-2, 6)), T = ut_random(0, 2000);
    UT_NEAR(tm_flow_stress(&m, eps, rate, T), tm_flow_stress(&jc, eps, rate, T), 1e-14);
    const tm_sym3 s = random_deviator(2e9);
    const double dt = pow(10, ut_random(-10, -6));
    UT_NEAR(tm_radial_return(&m, s, eps, T, dt).d_eps, tm_radial_return(&jc, s, eps, T, dt).d_eps, 1e-9);
  }
  /* softens with strain when hot, more than without tanh; no strength at the melting temperature; finite at the ends */
  m = johnson_cook_tanh();
  UT_TRUE(tm_flow_stress(&m, 1.0, 1e3, 900) < tm_flow_stress(&m, 0.2, 1e3, 900));
  UT_TRUE(tm_flow_stress(&m, 1.0, 1e3, 900) < tm_flow_stress(&jc, 1.0, 1e3, 900));
  UT_TRUE(tm_flow_stress(&m, 1.0, 1e3, m.t_melt) == 0 && tm_flow_stress(&m, 1.0, 1e3, 2 * m.t_melt) == 0);
  UT_NEAR(tm_flow_stress(&m, 0, 0, 0), m.jc_a, 1e-14);
  UT_TRUE(tm_flow_stress(&m, 1e6, 0, 300) > 0);
}

static tm_material zerilli_armstrong(int bcc)
{
  tm_material x = {0};
  x.strength = TM_STRENGTH_ZERILLI_ARMSTRONG;
  x.shear = bcc ? 8e10 : 4.6e10;
  x.za_rate0 = 1.0;
  x.za_c0 = 65e6;
  x.za_n = 0.289;
  if (bcc) {    /* Armco iron */
    x.za_c1 = 1033e6; x.za_c3 = 0.00698; x.za_c4 = 0.000415; x.za_c5 = 266e6; x.t_melt = 1811;
  } else {      /* OFHC copper */
    x.za_c2 = 890e6; x.za_c3 = 0.0028; x.za_c4 = 0.000115; x.t_melt = 1356;
  }
  return x;
}

static void check_zerilli_armstrong(void)
{
  const tm_material iron = zerilli_armstrong(1), copper = zerilli_armstrong(0);
  for (int k = 0; k < 300; k++) {
    const double eps = ut_random(0, 2), rate = pow(10, ut_random(-3, 6)), T = ut_random(0, 1300);
    const double ln = log(rate);
    UT_NEAR(tm_flow_stress(&iron, eps, rate, T),
            65e6 + 1033e6 * exp(-0.00698 * T + 0.000415 * T * ln) + 266e6 * pow(eps, 0.289), 1e-12);
    UT_NEAR(tm_flow_stress(&copper, eps, rate, T), 65e6 + 890e6 * sqrt(eps) * exp(-0.0028 * T + 0.000115 * T * ln), 1e-12);
    /* the unit of time does not matter: microseconds */
    tm_material other = iron;
    other.za_rate0 *= 1e-6;
    UT_NEAR(tm_flow_stress(&other, eps, rate * 1e-6, T), tm_flow_stress(&iron, eps, rate, T), 1e-12);
  }
  UT_NEAR(tm_flow_stress(&iron, 0, 0, 0), 65e6 + 1033e6, 1e-14);
  UT_NEAR(tm_flow_stress(&copper, 0, 0, 300), 65e6, 1e-14);
  UT_NEAR(tm_flow_stress(&iron, 0.1, 0, 300), tm_flow_stress(&iron, 0.1, 1e-4, 300), 1e-14);    /* the least rate */
  UT_NEAR(tm_flow_stress(&iron, -1e-9, 1, 300), tm_flow_stress(&iron, 0, 1, 300), 1e-14);
  UT_TRUE(tm_flow_stress(&iron, 1, 1, iron.t_melt) == 0 && tm_flow_stress(&iron, 1, 1, iron.t_melt - 1) > 65e6);
}

/* any law: 3G d = trial - Y at the end of the step */
static void check_searched_returns(tm_material m, double t_most)
{
  int most = 0;
  double sum = 0.0;
  for (int k = 0; k < 4000; k++) {
    const double eps = k % 5 ? pow(10, ut_random(-8, 0.5)) : 0, dt = pow(10, ut_random(-12, 0));
    const double T = ut_random(0, t_most);
    const double size = tm_flow_stress(&m, eps, 0, T) * pow(10, ut_random(-0.5, 0.5)) + 1;
    check_return(&m, random_deviator(size * (k % 11 ? 0.4 : 40)), eps, T, dt);
  }
  for (int k = 0; k < 4000; k++) {    /* a step of cutting */
    const double eps = ut_random(0, 2), dt = 1e-9, T = ut_random(300, 1000);
    const double d = dt * pow(10, ut_random(3, 6)), y = tm_flow_stress(&m, eps + d, d / dt, T);
    const tm_sym3 s = random_deviator(1), trial = tm_sym_scale((y + 3 * m.shear * d) / tm_sym_mises(s), s);
    const tm_return_result r = tm_radial_return(&m, trial, eps, T, dt);
    check_return(&m, trial, eps, T, dt);
    UT_NEAR(r.d_eps, d, 1e-4);
    if (r.iterations > most) most = r.iterations;
    sum += r.iterations;
  }
  printf("searched return: %.1f evaluations in a cutting step, %d at most\n", sum / 4000, most);
  UT_TRUE(most <= 30);
}

/* softening steeper than the elastic unloading: the stress of the end still lies on the flow curve */
static void check_steep_softening(void)
{
  tm_material m = johnson_cook_tanh();
  m.shear = 2e8;
  m.tanh_r = 20.0;
  for (int k = 0; k < 500; k++) {
    const double eps = ut_random(0, 1), T = ut_random(400, 1200), dt = 1e-6;
    const tm_sym3 s = random_deviator(1);
    const double y = tm_flow_stress(&m, eps, 0, T);
    check_return(&m, tm_sym_scale(y * ut_random(1.01, 1.5) / tm_sym_mises(s), s), eps, T, dt);
  }
}

int main(void)
{
  check_tanh();
  check_zerilli_armstrong();
  check_searched_returns(johnson_cook_tanh(), 1890);
  check_searched_returns(zerilli_armstrong(1), 1800);
  check_searched_returns(zerilli_armstrong(0), 1300);
  check_steep_softening();
  const tm_material steel = johnson_cook(553.1, 600.8, 0.234, 0.0134, 1, 293.15, 1733, 7870, 486);
  const tm_material copper = johnson_cook(90, 292, 0.31, 0.025, 1.09, 298, 1356, 8960, 383);
  const tm_material s4340 = johnson_cook(792, 510, 0.26, 0.014, 1.03, 298, 1793, 7830, 477);
  const double y_steel[5] = {903.634, 1162.428, 920.230, 869.397, 1047.06};
  const double y_copper[5] = {233.015, 381.758, 285.117, 274.625, 416.35};
  const double y_4340[5] = {1072.266, 1335.676, 1080.255, 1022.564, 1167.18};
  check_table(&steel, y_steel, 537.16);
  check_table(&copper, y_copper, 390.94);
  check_table(&s4340, y_4340, 584.85);
  check_limits(&steel);
  check_limits(&copper);
  check_simple_shear();
  for (int k = 0; k < 100; k++) check_jaumann_products();
  check_returns(steel);
  check_returns(copper);
  check_steps();
  check_other_kinds();

  const tm_sym3 trial = tm_sym(3e8, -1e8, -2e8, 1e8, 0, 5e7);
  const tm_return_result melt = tm_radial_return(&steel, trial, 0.1, 1800, 1e-9);
  UT_TRUE(tm_sym_mises(melt.s) == 0 && melt.yield == 0);
  UT_NEAR(melt.d_eps, tm_sym_mises(trial) / (3 * steel.shear), 1e-14);
  const tm_return_result still = tm_radial_return(&steel, tm_sym(0, 0, 0, 0, 0, 0), 0, 1800, 1e-9);
  UT_TRUE(still.d_eps == 0 && still.s.xx == 0);
  return ut_summary();
}
