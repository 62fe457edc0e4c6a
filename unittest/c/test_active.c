/* Who sleeps: a line of particles with a spacing of 1 and a reach of 2.5, of which some move, stand in the region, near a tool
   that is turned, or only conduct; what those that come to rest lose; the flag of a ghost. */
#include "tm_active.h"
#include "ut_state.h"

enum { N = 40, OWN = 38 };    /* behind the owned: ghosts at the end of the line */

static ut_particles p;
static tm_active_args a;
static tm_tool_box tool;
static int inside[N], cell[N], begin[1000], order[N + TM_COLUMN], marked[N + 1];
static tm_real flag[N], column[3][N + TM_COLUMN];
static unsigned char marks[N];

static void sort(void)
{
  tm_cells *c = &a.cells;
  tm_bounds b = tm_bounds_nothing();
  for (int i = 0; i < N; i++) {
    const tm_bounds one = tm_bounds_of(p.x + 3 * i);
    tm_bounds_sum(&b, &one);
  }
  c->n = N;
  c->x = p.x;
  tm_cells_make(c, b, a.radius, TM_CELLS_SPARE * a.radius, 0, 999);
  c->cell = cell;
  c->begin = begin;
  c->index = order;
  c->marked = marked;
  for (int d = 0; d < 3; d++) c->column[d] = column[d];
  int k = 0;
  for (int q = 0; q < tm_cells_number(c); q++) {
    begin[q] = k;
    for (int i = 0; i < N; i++)
      if (tm_cells_of(c, p.x + 3 * i) == q) tm_cells_put(c, i, k++);
  }
  begin[tm_cells_number(c)] = k;
}

static void start(void)
{
  ut_particles_make(&p);
  memset(&a, 0, sizeof a);
  memset(inside, 0, sizeof inside);
  memset(flag, 0, sizeof flag);
  a.state = p.state;
  for (int i = 0; i < N; i++) p.x[3 * i] = i;
  for (int t = 0; t < 4; t++) p.material[t].body = TM_BODY_SOLID;
  a.dimension = 2;
  a.still2 = 0.25;
  a.radius = 2.5;
  a.from_tool = 2.5;
  a.flag = flag;
  a.marks = marks;
  sort();
}

static void mark(tm_real least)
{
  a.least = least;
  for (int i = 0; i < N; i++) marks[i] = a.flag[i] >= a.least;
  marked[0] = 0;
  for (int k = 0; k < N; k++) marked[k + 1] = marked[k] + marks[order[k]];
}

static double decide(void)
{
  double energy = 0.0;
  for (int i = 0; i < OWN; i++) flag[i] = tm_active_flag(i, &a);
  mark(TM_MOVING);
  for (int i = 0; i < OWN; i++) tm_active_wake(i, &a);
  mark(TM_AWAKE);
  for (int i = 0; i < OWN; i++) energy += tm_active_sort(i, &a);
  return energy;
}

/* active from one to another, at the edge beside them, all others asleep */
static void expect(int from, int to)
{
  for (int i = 0; i < OWN; i++) {
    const int away = i < from ? from - i : i > to ? i - to : 0;
    UT_TRUE((int) p.field[TM_F_ACTIVE][i] == (away == 0 ? TM_ACTIVE_MOVES : away <= 2 ? TM_ACTIVE_EDGE : TM_ACTIVE_ASLEEP));
  }
}

int main(void)
{
  start();
  p.v[3 * 20 + 1] = 0.5;    /* just fast enough: its neighbors move with it, and theirs stand */
  UT_TRUE(decide() == 0.0);
  expect(18, 22);

  start();
  p.v[3 * 20 + 1] = 0.4;
  UT_NEAR(decide(), 0.5 * 2.0 * 0.16, 1e-14);    /* too slow: it comes to rest, with what it had */
  expect(-10, -10);
  UT_TRUE(p.v[3 * 20 + 1] == 0.0);

  start();
  for (int i = 10; i < 13; i++) inside[i] = 1;
  a.inside = inside;
  p.v[3 * 11] = 0.4;
  p.v[3 * 13] = 0.4;
  p.field[TM_F_HISTORY][TM_H_COLUMNS * 13] = 7.0;
  UT_NEAR(decide(), 0.16, 1e-14);    /* at the edge it loses velocity and rates, in the region it keeps them */
  expect(10, 12);
  UT_TRUE(p.v[3 * 11] == 0.4 && p.v[3 * 13] == 0.0 && p.field[TM_F_HISTORY][TM_H_COLUMNS * 13] == 0.0);
  p.field[TM_F_HISTORY][TM_H_COLUMNS * 13] = 7.0;
  UT_TRUE(decide() == 0.0);    /* and stays there: its rates are those of its stress */
  UT_TRUE(p.field[TM_F_HISTORY][TM_H_COLUMNS * 13] == 7.0);

  /* a box of 2 x 8 that stands upright in its own frame and lies in space: it ends at x = 4 - 0.4 */
  start();
  tool.origin = tm_vec(-0.4, 1.0, 0.0);
  tool.axis[0] = tm_vec(0.0, 1.0, 0.0);
  tool.axis[1] = tm_vec(-1.0, 0.0, 0.0);
  tool.axis[2] = tm_vec(0.0, 0.0, 1.0);
  for (int d = 0; d < 3; d++) {
    tool.lo[d] = d == 1 ? -4.0 : -1.0;
    tool.hi[d] = d == 1 ? 4.0 : 1.0;
  }
  a.tool = &tool;
  a.tools = 1;
  decide();
  expect(0, 6);
  p.x[2] = 9.0;
  UT_TRUE(tm_tool_box_near(&tool, p.x, 1e-9, 2) && !tm_tool_box_near(&tool, p.x, 7.9, 3) &&
          tm_tool_box_near(&tool, p.x, 8.1, 3));

  start();
  p.type[30] = 2;
  p.material[2].body = TM_BODY_SOLID + 1;    /* what only conducts is always active */
  decide();
  expect(30, 30);

  start();
  flag[38] = TM_MOVING;    /* another rank's */
  decide();
  expect(36, 38);

  start();
  for (int k = 0; k < 3 * N; k++) p.force[k] = 1.0;
  tm_active_hold(34, p.force);
  for (int k = 0; k < 3 * N; k++) UT_TRUE(p.force[k] == (k / 3 == 34 ? 0.0 : 1.0));
  return ut_summary();
}
