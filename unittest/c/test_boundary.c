/* Whose mechanical neighbors are all owned: particles in a line, each with those up to two places away, the last two ghosts. */
#include "tm_boundary.h"
#include "ut.h"

#include <string.h>

enum { N = 10, OWN = 8, ROOM = 5 };

static int row[N * ROOM], mechanical[N], thermal[N], contact[N];
static ptrdiff_t first[N];
static unsigned char marks[N];
static tm_boundary_args a;

static void line(int with_thermal)
{
  for (int i = 0; i < OWN; i++) {
    int n = 0;
    for (int j = i - 2; j <= i + 2; j++)
      if (j >= 0 && j < N && j != i && (!with_thermal || j < OWN)) row[ROOM * i + n++] = j;
    mechanical[i] = n;
    thermal[i] = 0;
    if (with_thermal) { /* ghosts that only exchange heat do not count */
      row[ROOM * i + n] = N - 1;
      thermal[i] = 1;
    }
    first[i] = ROOM * i;
  }
}

static void mark(void)
{
  memset(marks, 0, sizeof marks);
  for (int i = 0; i < OWN; i++) tm_boundary_mark(i, &a);
}

int main(void)
{
  a.rows.index = row;
  a.rows.mechanical = mechanical;
  a.rows.thermal = thermal;
  a.rows.contact = contact;
  a.rows.first = first;
  a.rows.stride = 1;
  a.owned = OWN;
  a.marks = marks;
  line(0);
  mark();
  for (int wanted = 0; wanted < 2; wanted++) { /* each is in one list: the last two have ghosts */
    a.wanted = wanted;
    for (int i = 0; i < OWN; i++) UT_TRUE(tm_boundary_wanted(i, &a) == ((i >= OWN - 2) == wanted));
  }
  line(1);
  mark();
  a.wanted = 1;
  for (int i = 0; i < OWN; i++) UT_TRUE(!tm_boundary_wanted(i, &a));
  mechanical[3] = 0; /* alone */
  row[ROOM * 5] = N - 2;
  mark();
  for (int i = 0; i < OWN; i++) UT_TRUE(tm_boundary_wanted(i, &a) == (i == 5));
  return ut_summary();
}
