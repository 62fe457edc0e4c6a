"""Malformed scripts: the pair_style line. See bad_input.py."""
from bad_input import THREE_D, fine, run_all, style, warned, wrong

S = "sph/tm"

fine("base script", {})
fine("base script in 3D", THREE_D)

wrong("pair_style without arguments", style(""), S, "kernel", "spacing")
wrong("pair_style with a kernel only", style("hyperbolic"), S, "spacing")
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
wrong("viscosity beta nan", style("hyperbolic 1.2 spacing 1e-3 viscosity 1 nan"), S, "viscosity beta", "nan")
wrong("artstress 2", style("hyperbolic 1.2 spacing 1e-3 artstress 2 4"), S, "artstress", "0 to 1", "2")
wrong("artstress exponent 0", style("hyperbolic 1.2 spacing 1e-3 artstress 0.3 0"), S, "artstress exponent", "1 to 8",
      "0")
wrong("artstress exponent 2.5", style("hyperbolic 1.2 spacing 1e-3 artstress 0.3 2.5"), "2.5", "integer")
wrong("artstress with a wrong form", style("hyperbolic 1.2 spacing 1e-3 artstress 0.3 4 principle"), S, "principle")
wrong("hourglass 2", style("hyperbolic 1.2 spacing 1e-3 hourglass 2"), S, "hourglass", "0 to 1", "2")
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
warned("spacing far below the lattice", style("hyperbolic 1.2 spacing 0.1e-3"), S, "spacing", "0.0001",
       "no particle has a neighbor")
wrong("spacing below the lattice", style("hyperbolic 1.2 spacing 0.6e-3"), S, "spacing", "0.0006", "spacing 0.001'")
wrong("spacing above the lattice", style("hyperbolic 1.2 spacing 2e-3"), S, "spacing", "0.002", "spacing 0.001")
wrong("spacing in another unit", style("hyperbolic 1.2 spacing 1"), S, "spacing 1", "area of 64", "0.0004")
wrong("/kk without Kokkos", {"pair_style": "pair_style sph/tm/kk hyperbolic 1.2 spacing 1e-3"}, "sph/tm/kk", "KOKKOS")
wrong("fix /kk", {"fix": "fix body all sph/tm/kk"}, "sph/tm/kk", "sph/tm")
wrong("compute /kk without Kokkos", {"compute": "compute p all sph/tm/atom/kk pstrain"}, "sph/tm/atom/kk", "KOKKOS")

run_all()
