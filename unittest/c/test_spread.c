/* Friction heat of a tool of particles: nothing is lost, it goes by the kernel, and who finds nobody is told. */
#include "tm_spread.h"
#include "ut_state.h"

enum { N = 30 };
static double records[TM_REC * N], heat[N], given[N], source[N];
static int type[N], none[N], length[N], rows[N * N];
static ptrdiff_t first[N];

int main(void)
{
  tm_spread_args a;
  memset(&a, 0, sizeof a);
  a.main = records;
  a.type = type;
  a.body_type = 2;
  a.kernel = TM_KERNEL_WENDLAND_C2;
  a.h = 1.2;
  a.heat = heat;
  a.source = source;
  a.rows.index = rows; a.rows.first = first; a.rows.stride = 1;
  a.rows.mechanical = none; a.rows.thermal = length; a.rows.contact = none;
  for (int i = 0; i < N; i++) {
    type[i] = 1 + i % 2;
    for (int d = 0; d < 3; d++) records[TM_REC * i + d] = ut_random(0, 2);
    first[i] = N * i;
    source[i] = i;
    given[i] = heat[i] = type[i] == 1 && i % 4 == 0 ? ut_random(1, 5) : 0.0;
  }
  records[TM_REC * 8] = 50.0;                         /* one is far from all */
  for (int i = 0; i < N; i++)
    for (int j = 0; j < N; j++)
      if (j != i && type[i] != type[j] && i != 8 && j != 8) rows[N * i + length[i]++] = j;
  double all = 0.0, taken = 0.0;
  for (int i = 0; i < N; i++) {
    const int alone = tm_spread_divide(i, &a);
    UT_TRUE(alone == (i == 8));
    all += i == 8 ? 0.0 : given[i];
  }
  heat[8] = 0.0;
  for (int j = 0; j < N; j++) tm_spread_collect(j, tm_group_alone(), &a);
  for (int j = 0; j < N; j++) {
    taken += source[j] - j;
    if (type[j] == 1) UT_TRUE(source[j] == j);
  }
  UT_NEAR(taken, all, 1e-13);

  /* one that rubs between two: by their weights */
  records[0] = records[1] = records[2] = 0.0;
  for (int j = 1; j <= 3; j += 2) {
    records[TM_REC * j] = j == 1 ? 0.6 : -1.2;
    records[TM_REC * j + 1] = records[TM_REC * j + 2] = 0.0;
    source[j] = 0.0;
  }
  rows[0] = 1; rows[1] = 3; rows[2] = 2;              /* 2 is near too, but no particle of the tool */
  rows[N * 2] = 0;
  length[2] = 1;
  records[TM_REC * 2] = records[TM_REC * 2 + 1] = 0.0;
  records[TM_REC * 2 + 2] = 0.3;
  const double before = source[2];
  length[0] = 3;
  for (int j = 1; j <= 3; j += 2) {
    rows[N * j] = 0;
    length[j] = 1;
  }
  heat[0] = 10.0;
  UT_TRUE(!tm_spread_divide(0, &a));
  for (int j = 1; j <= 3; j++) tm_spread_collect(j, tm_group_alone(), &a);
  UT_TRUE(source[2] == before);
  const double near = tm_kernel_shape(a.kernel, 0.5), far = tm_kernel_shape(a.kernel, 1.0);
  UT_NEAR(source[1], 10.0 * near / (near + far), 1e-14);
  UT_NEAR(source[3], 10.0 * far / (near + far), 1e-14);
  return ut_summary();
}
