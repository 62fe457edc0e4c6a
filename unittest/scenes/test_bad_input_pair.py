"""Malformed scripts: the pair_style line. See bad_input.py."""
from bad_input import GOOD, THREE_D, fine, run_all, style, warned, wrong

S = "sph/tm"

fine("base script", {})
fine("base script in 3D", THREE_D)

wrong("pair_style without arguments", style(""), S, "kernel", "spacing")
wrong("pair_style with a kernel only", style("hyperbolic"), S, "spacing")
warned("lengths in m in units metal", {"units": "units metal"}, "spacing 0.001", "1e-13 m in units metal", "less than an atom")
wrong("unknown kernel", style("gauss 1.2 spacing 1e-3"), S, "kernel", "gauss", "hyperbolic", "wendland/c4")
for bad in ("0", "-1.2", "nan", "inf", "0.5", "20", "abc"):
    wrong("ratio " + bad, style("hyperbolic %s spacing 1e-3" % bad), S if bad != "abc" else "", bad)
wrong("no spacing", style("hyperbolic 1.2 xsph 0.5"), S, "spacing")
wrong("spacing without value", style("hyperbolic 1.2 spacing"), S, "spacing")
wrong("spacing twice without value", style("hyperbolic 1.2 spacing 1e-3 spacing"), S, "spacing", "1 value")
for bad in ("0", "-1e-3", "nan", "inf"):
    wrong("spacing " + bad, style("hyperbolic 1.2 spacing " + bad), S, "spacing", "positive", bad)
wrong("unknown pair_style keyword", style("hyperbolic 1.2 spacing 1e-3 viscous 1 1"), S, "viscous", "known are",
      "viscosity")
wrong("viscosity with one value", style("hyperbolic 1.2 spacing 1e-3 viscosity 1"), S, "viscosity", "2 values")
wrong("negative viscosity", style("hyperbolic 1.2 spacing 1e-3 viscosity -1 1"), S, "viscosity alpha", "-1", ">= 0")
wrong("shock above 1", style("hyperbolic 1.2 spacing 1e-3 shock 1.5"), S, "shock", "1.5")
wrong("shock with artificial stress", style("hyperbolic 1.2 spacing 1e-3 shock 1 stabilize artstress"), S, "shock 1", "artificial stress",
      "viscosity")
wrong("shock without hourglass control", style("hyperbolic 1.2 spacing 1e-3 shock 0.5 hourglass 0"), S, "shock 0.5", "hourglass")
wrong("shock with correction second", style("hyperbolic 1.2 spacing 1e-3 correction second shock 1"), S, "shock 1", "correction second")
wrong("viscosity beta nan", style("hyperbolic 1.2 spacing 1e-3 viscosity 1 nan"), S, "viscosity beta", "nan")
wrong("artstress 2", style("hyperbolic 1.2 spacing 1e-3 artstress 2 4"), S, "artstress", "0 to 1", "2")
wrong("artstress exponent 0", style("hyperbolic 1.2 spacing 1e-3 artstress 0.3 0"), S, "artstress exponent", "1 to 8",
      "0")
wrong("artstress exponent 2.5", style("hyperbolic 1.2 spacing 1e-3 artstress 0.3 2.5"), "2.5", "integer")
wrong("artstress with a wrong form", style("hyperbolic 1.2 spacing 1e-3 artstress 0.3 4 principle"), S, "principle")
wrong("hourglass 2", style("hyperbolic 1.2 spacing 1e-3 hourglass 2"), S, "hourglass", "0 to 1", "2")
for bad in ("-0.1", "automatic", "nan"):
    wrong("hourglass " + bad, style("hyperbolic 1.2 spacing 1e-3 hourglass " + bad), *([] if bad == "automatic" else [S]), bad)
wrong("hourglass without value", style("hyperbolic 1.2 spacing 1e-3 hourglass"), S, "hourglass")
wrong("stabilize nothing", style("hyperbolic 1.2 spacing 1e-3 stabilize nothing"), S, "stabilize", "hourglass or artstress",
      "nothing")
wrong("stabilize without value", style("hyperbolic 1.2 spacing 1e-3 stabilize"), S, "stabilize")
for good in ("stabilize artstress", "stabilize hourglass", "hourglass auto", "hourglass 0.02 correction no", "hourglass 0", "form f14"):
    fine(good, style("hyperbolic 1.2 spacing 1e-3 " + good))
wrong("xsph 1.5", style("hyperbolic 1.2 spacing 1e-3 xsph 1.5"), S, "xsph", "0 to 1", "1.5")
wrong("precision single", style("hyperbolic 1.2 spacing 1e-3 precision single"), S, "precision", "double or mixed",
      "single")
wrong("form f16", style("hyperbolic 1.2 spacing 1e-3 form f16"), S, "form", "f15 or f14", "f16")
wrong("balsara perhaps", style("hyperbolic 1.2 spacing 1e-3 balsara perhaps"), "perhaps")
wrong("correction with form f14", style("hyperbolic 1.2 spacing 1e-3 correction yes form f14"), S, "correction",
      "form f15")
wrong("plane bend", style("hyperbolic 1.2 spacing 1e-3 plane bend"), S, "plane", "strain or stress", "bend")
wrong("plane stress in 3D", dict(THREE_D, **style("hyperbolic 1.2 spacing 1e-3 plane stress")), S, "plane stress",
      "dimension 2")
wrong("spacing far below the lattice", style("hyperbolic 1.2 spacing 0.1e-3"), S, "no particle has a neighbor", "0.0001",
      "lattice in use has 0.001", "spacing lattice")
wrong("spacing below the lattice", style("hyperbolic 1.2 spacing 0.6e-3"), S, "spacing", "0.0006", "spacing 0.001'")
wrong("spacing above the lattice", style("hyperbolic 1.2 spacing 2e-3"), S, "spacing", "0.002", "spacing 0.001")
wrong("spacing 10 % below the lattice", style("hyperbolic 1.2 spacing 0.9e-3"), S, "spacing 0.0009", "spacing 0.001'")
wrong("spacing 10 % above the lattice", style("hyperbolic 1.2 spacing 1.1e-3"), S, "spacing 0.0011", "spacing 0.001'")
warned("spacing 6 % below the lattice", style("hyperbolic 1.2 spacing 0.94e-3"), S, "spacing 0.00094", "spacing 0.001'")
warned("spacing 6 % above the lattice", style("hyperbolic 1.2 spacing 1.06e-3"), S, "spacing 0.00106", "spacing 0.001'")
for spacing in "0.98e-3", "1.03e-3":
    warned("spacing %s" % spacing, dict(THREE_D, **style("hyperbolic 1.2 spacing " + spacing)), S, "apart", "times the mass of their volume", "spacing 0.001'")
fine("spacing 1 % above the lattice", dict(THREE_D, **style("hyperbolic 1.2 spacing 1.01e-3")))
for kernel in "hyperbolic", "cubic", "quintic", "wendland/c2", "wendland/c4":
    for ratio in "1", "1.2", "1.6", "2.2":
        fine("lattices of %s %s" % (kernel, ratio), style(kernel + " " + ratio + " spacing lattice"))
        fine("cubic lattices of %s %s" % (kernel, ratio),
             dict(THREE_D, **style(kernel + " " + ratio + " spacing lattice")))
for lattice in "fcc", "bcc", "hcp", "diamond":
    case = fine if lattice != "diamond" else lambda *a: None    # no packing that a body has
    case(lattice, dict(THREE_D, lattice="lattice %s 1e-3" % lattice, **style("hyperbolic 1.4 spacing lattice")))
fine("hexagons", dict({"lattice": "lattice hex 1e-3"}, **style("hyperbolic 1.2 spacing lattice")))
fine("a turned lattice", dict({"lattice": "lattice sq 1e-3 orient x 1 1 0 orient y -1 1 0"},
                              **style("hyperbolic 1.2 spacing lattice")))
wrong("no lattice to take the spacing from", dict({"lattice": "", "atoms": "create_atoms 1 random 60 1 work"},
                                                  **style("hyperbolic 1.2 spacing lattice")), S, "spacing lattice",
      "no lattice in use")
SECOND = "lattice sq 1e-3 origin {0} 0\nregion other block {1} INF INF units box\ncreate_atoms 1 region other\n"
wrong("a lattice over another", {"atoms": "create_atoms 1 region work\n" + SECOND.format("0 0", "0 4e-3 0 8e-3")}, S,
      "times the mass around it", "lie over each other")
wrong("two bodies half a spacing apart",
      {"atoms": "create_atoms 1 region work\n" + SECOND.format("0 0.5", "8e-3 12e-3 0 8e-3")}, S, "too close together")
wrong("two bodies half a spacing apart in 3D",
      dict(THREE_D, atoms="create_atoms 1 region work\nlattice sc 1e-3 origin 0 0.5 0.5\n"
           "region other block 4.9e-3 10e-3 0 5e-3 0 5e-3 units box\ncreate_atoms 1 region other"), S,
      "too close together")
fine("two bodies one spacing apart", {"atoms": "create_atoms 1 region work\n" + SECOND.format("0.5 0", "8e-3 12e-3 0 8e-3")})
wrong("a box too thin for LAMMPS's bins", {"box": "region box block -5e-3 15e-3 -5e-3 15e-3 -5e-6 5e-6 units box"}, S,
      "spacing 0.001", "only 1e-05 long in z", "thickness")
wrong("spacing in another unit", style("hyperbolic 1.2 spacing 1"), S, "spacing 1", "area of 64", "0.0004")
wrong("/kk without Kokkos", {"pair_style": "pair_style sph/tm/kk hyperbolic 1.2 spacing 1e-3"}, "sph/tm/kk", "KOKKOS")
wrong("fix /kk", {"fix": "fix body all sph/tm/kk"}, "sph/tm/kk", "sph/tm")
wrong("compute /kk without Kokkos", {"compute": "compute p all sph/tm/atom/kk pstrain"}, "sph/tm/atom/kk", "KOKKOS")



def bodies(row, law="contact"):
    """A second body whose lowest row is at so many spacings; the highest of the first is at 7.5."""
    return {"create_box": "create_box 2 box", "pair_coeff": "pair_coeff * * %s\npair_coeff 1 2 %s" % (GOOD, law),
            "atoms": "create_atoms 1 region work\nlattice sq 1e-3 origin 0.5 %g 0\nregion top block 0 8e-3 %g 12e-3 INF INF units box\n"
                     "create_atoms 2 region top" % (row % 1, 1e-3 * row - 1e-5)}


fine("bodies that touch", bodies(8.5))
for twice in "friction/table 300 0.1 600 0.2 friction 0.2", "friction 0.2 friction/table 300 0.1 600 0.2", "friction 0.1 friction 0.2":
    wrong("friction of bodies given twice: " + twice, bodies(8.5, "contact " + twice), "Pair sph/tm coeff contact", "types 1 2", "once")
warned("bodies 0.2 spacings inside of each other", bodies(8.3), S, "bodies in contact", "inside of each other", "throw")
warned("bodies half a spacing inside of each other", bodies(8.0), S, "bodies in contact", "inside of each other", "throw")
for row in 7.8, 7.6, 5.5, 5.25:
    wrong("bodies inside of each other, first row at %g" % row, bodies(row), "Pair style sph/tm", "bodies in contact", "one spacing apart")
wrong("bodies in contact, twice the spacing", dict(bodies(8.5), **style("hyperbolic 1.2 spacing 2e-3")), "Pair style sph/tm", "write 'spacing")
warned("neighbors left out", dict(bodies(8.5), more="neigh_modify exclude type 1 2"), "neigh_modify exclude", "contact")
warned("bodies whose friction table is in degrees Celsius", bodies(8.5, "contact friction/table 20 0.1 500 0.3"), "friction/table", "20 K", "kelvin")
run_all()
