/* SPH-TM: checks for the C tests. A test is one program: main() calls UT_... and ends with
   return ut_summary(), which is nonzero when a check failed. Random numbers repeat. */
#ifndef UT_H
#define UT_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>

static int ut_checks, ut_failures;
static uint64_t ut_state = 88172645463325252ull;

static inline void ut_report(int ok, const char *file, int line, const char *what, double value,
                             double expected)
{
  ut_checks++;
  if (ok) return;
  if (ut_failures++ < 20)
    printf("%s:%d: %s is %.15g, expected %.15g\n", file, line, what, value, expected);
}
/* uniform in [lo, hi) */
static inline double ut_random(double lo, double hi)
{
  ut_state ^= ut_state << 13;
  ut_state ^= ut_state >> 7;
  ut_state ^= ut_state << 17;
  return lo + (hi - lo) * (double) (ut_state >> 11) / 9007199254740992.0;
}
static inline int ut_close(double a, double b, double tol) { return fabs(a - b) <= tol; }
static inline int ut_summary(void)
{
  printf("%d checks, %d failed\n", ut_checks, ut_failures);
  return ut_failures != 0 || ut_checks == 0;
}

/* |value - expected| <= rel |expected|; UT_WITHIN takes an absolute tolerance. NaN fails. */
#define UT_NEAR(value, expected, rel) UT_WITHIN(value, expected, (rel) * fabs((double) (expected)))
#define UT_WITHIN(value, expected, tol)                                                       \
  do {                                                                                        \
    const double ut_v = (value), ut_e = (expected);                                           \
    ut_report(ut_close(ut_v, ut_e, tol), __FILE__, __LINE__, #value, ut_v, ut_e);             \
  } while (0)
#define UT_TRUE(condition) ut_report(!!(condition), __FILE__, __LINE__, #condition, 0, 1)

#endif
