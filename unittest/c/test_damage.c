/* Damage: fracture strains worked out from the formula by hand, limits, failed material. */
#include "tm_damage.h"
#include "ut.h"

static tm_material ofhc(void)
{
  tm_material m = {0};
  m.strength = TM_STRENGTH_JOHNSON_COOK;
  m.damage = TM_DAMAGE_JOHNSON_COOK;
  m.d1 = 0.54; m.d2 = 4.89; m.d3 = -3.03; m.d4 = 0.014; m.d5 = 1.12;
  m.jc_rate0 = 1;
  m.t_ref = 298; m.t_melt = 1356;
  return m;
}
static double strain(const tm_material *m, double triaxiality, double rate, double T)
{
  return 1 / tm_damage_increment(m, triaxiality * 2e8, 2e8, 1.0, rate, T);
}

int main(void)
{
  const tm_material m = ofhc();
  /* 0.54 + 4.89 exp(-3.03/3) = 2.321031, (1 + 0.014 ln 1e3) = 1.0967086, 1 + 1.12/2 = 1.56 */
  UT_NEAR(strain(&m, 1.0 / 3, 1, 298), 2.3210308, 1e-7);
  UT_NEAR(strain(&m, 1.0 / 3, 1e3, 298), 2.3210308 * 1.0967086, 1e-7);
  UT_NEAR(strain(&m, 1.0 / 3, 1e3, 827), 2.3210308 * 1.0967086 * 1.56, 1e-7);
  UT_NEAR(strain(&m, 0, 1, 298), 5.43, 1e-12);
  UT_TRUE(strain(&m, -0.5, 1, 298) > strain(&m, 0, 1, 298));   /* pressure makes ductile */
  UT_NEAR(strain(&m, 9, 1, 298), strain(&m, 1.5, 1, 298), 1e-14);
  UT_NEAR(strain(&m, -99, 1, 298), strain(&m, -3, 1, 298), 1e-14);
  UT_NEAR(strain(&m, 0, 1e-6, 100), 5.43, 1e-12);              /* slower and colder: no change */
  UT_NEAR(strain(&m, 0, 1, 9999), 5.43 * 2.12, 1e-12);         /* melted: T* = 1 */
  UT_NEAR(tm_damage_increment(&m, 0, 0, 0.543, 1, 298), 0.1, 1e-12);   /* no stress at all */
  UT_NEAR(tm_damage_increment(&m, 0, 1, 0.0543, 1, 298), 0.01, 1e-12);
  UT_TRUE(tm_damage_increment(&m, 1e9, 1, 0, 1, 298) == 0);
  UT_TRUE(tm_damage_increment(&m, 1e9, 1, -1, 1, 298) == 0);
  UT_TRUE(!tm_damage_failed(&m, 0.999, 100) && tm_damage_failed(&m, 1, 0));

  tm_material weldox = ofhc();  /* Weldox 460E: no rate, no temperature */
  weldox.d1 = 0.636; weldox.d2 = 1.936; weldox.d3 = -2.969; weldox.d4 = weldox.d5 = 0;
  weldox.jc_rate0 = weldox.t_ref = weldox.t_melt = 0;
  UT_NEAR(strain(&weldox, 1, 1e5, 900), 0.636 + 1.936 * 0.05135462, 1e-7);

  tm_material brittle = ofhc();
  brittle.d1 = -10;
  UT_TRUE(tm_damage_increment(&brittle, 0, 1, 1e-6, 1, 298) >= 1);

  tm_material limit = ofhc(), none = ofhc();
  limit.damage = TM_DAMAGE_STRAIN;
  limit.strain_max = 1.2;
  UT_NEAR(tm_damage_increment(&limit, 0, 1, 0.3, 1, 298), 0.25, 1e-14);
  UT_TRUE(!tm_damage_failed(&limit, 7, 1.19) && tm_damage_failed(&limit, 0, 1.2));
  none.damage = TM_DAMAGE_NONE;
  UT_TRUE(tm_damage_increment(&none, 0, 1, 1, 1, 298) == 0 && !tm_damage_failed(&none, 9, 9));

  UT_TRUE(tm_damage_pressure(-5, 1) == 0 && tm_damage_pressure(5, 1) == 5);
  UT_TRUE(tm_damage_pressure(-5, 0) == -5 && tm_damage_pressure(5, 0) == 5);
  return ut_summary();
}
