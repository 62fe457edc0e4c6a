"""Bodies that expand by heat, and what the energies say of it: a free cube stores nothing; a plate in plane stress, free or held, keeps the sum of the
energies and is not stopped for the heat that it gets."""
from sphtm_scene import PLANE, SPACE, Checks, run

E, NU, ALPHA, RISE = 70e9, 0.33, 2.3e-5, 100.0
SCRIPT = """
lattice         {lattice} 1e-3 origin 0.5 0.5 {z}
region          box block -5e-3 15e-3 -5e-3 15e-3 {deep} units box
create_box      1 box
region          body block 0 {long} 0 8e-3 {thick} units box
create_atoms    1 region body
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3 {style}
pair_coeff      1 1 density 2700 elastic 70e9 0.33 heat 0 900 0.9 expansion 2.3e-5
fix             body all sph/tm temperature 300 energy yes courant {courant}
variable        warm equal 300+100*0.5*(1-cos(PI*time/{t}))*(time<{t})+100*(time>={t})
variable        power equal 4.86e12*(time<{t})
fix             hot all sph/tm/heat {heat}
{more}
compute         p all sph/tm/atom stress/xx
compute         mean all reduce ave c_p
variable        left equal 1.5*{t}-time
fix             stop all halt 10 v_left < 0 error continue message no
thermo          100
thermo_style    custom step time pe f_body[1] f_body[2] f_body[9] f_body[13] c_mean
thermo_modify   norm no format float %.12g
run             100000
"""
FLAT, DEEP = dict(lattice="sq", z="0", deep="-0.5e-3 0.5e-3", thick="INF INF"), dict(lattice="sc", z="0.5", deep="-5e-3 15e-3", thick="0 8e-3")
checks = Checks()


def heated(space, style="", more="", courant=0.4, t=5e-5, long="8e-3", heat="temperature v_warm"):
    r = run((PLANE if space is FLAT else SPACE) + SCRIPT.format(style=style, more=more, courant=courant, t=t, long=long, heat=heat, **space), expect_error=True)
    return r, r.thermo[-1]


# if the thermal strain were elastic this would be stored: K (3 alpha dT)^2/2 per volume
r, t = heated(DEEP)
locked = 0.5 * E / (3 * (1 - 2 * NU)) * (3 * ALPHA * RISE) ** 2 * (8e-3) ** 3
checks.true("free cube: goes on", r.status == 0 and not r.warnings(), "%s %s" % (r.errors(), r.warnings()))
checks.below("free cube: stored, over what its thermal strain would store", abs(t["PotEng"][-1]) / locked, 0.01)
checks.below("free cube: work neither stored nor dissipated", abs(t["f_body[13]"][-1]) / locked, 1e-3)
checks.below("free cube: drift of the sum", abs(t["f_body[9]"] - t["f_body[9]"][0]).max() / locked, 1e-3)

HELD = "region ends block 2e-3 8e-3 INF INF INF INF units box side out\ngroup ends region ends\nfix held ends setforce 0 NULL NULL\n"
# a power that is given is known in the step; of a temperature that is prescribed the step learns at its end, so its error is of first order
for heat, least in (("source v_power", 1e-3), ("temperature v_warm", 0.02)):
    for name, more, long in (("free", "", "8e-3"), ("held at both ends", HELD, "10e-3")):
        name += ", heated by " + heat.split()[0]
        drifts = []
        for courant in 0.4, 0.2:
            r, t = heated(FLAT, style="plane stress", more=more, courant=courant, long=long, heat=heat)
            checks.true("plate in plane stress, %s: goes on" % name, r.status == 0 and "drifted" not in "%s" % r.warnings(),
                        "%s %s" % (r.errors(), r.warnings()))
            locked = 0.5 * E * (ALPHA * RISE) ** 2 * 8e-3 * 8e-3
            drifts.append(abs(t["f_body[9]"] - t["f_body[9]"][0]).max() / locked)
        checks.below("%s: drift of the sum over E (alpha dT)^2/2 times the volume" % name, drifts[0], least)
        checks.below("%s: half of the courant number, over that" % name, drifts[1] / drifts[0], 0.6)
        if more:
            checks.near("%s: stress along it over E alpha dT" % name, -t["c_mean"][-1] / (E * ALPHA * RISE), 1, 0.1)
checks.end()
