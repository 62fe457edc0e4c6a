"""SI values of LAMMPS's unit styles."""
AMU, BOHR, HARTREE, MOL = 1.66053906660e-27, 5.29177210903e-11, 4.3597447222071e-18, 6.02214076e23
UNITS = {    # SI value of mass, length, time, energy, force, pressure, density (doc page of the command units)
    "si": (1, 1, 1, 1, 1, 1, 1), "lj": (1, 1, 1, 1, 1, 1, 1),
    "cgs": (1e-3, 1e-2, 1, 1e-7, 1e-5, 0.1, 1e3),
    "real": (AMU, 1e-10, 1e-15, 4184 / MOL, 4184 / MOL / 1e-10, 101325, 1e3),
    "metal": (AMU, 1e-10, 1e-12, 1.602176634e-19, 1.602176634e-9, 1e5, 1e3),
    "electron": (AMU, BOHR, 1e-15, HARTREE, HARTREE / BOHR, 1, AMU / BOHR ** 3),
    "micro": (1e-15, 1e-6, 1e-6, 1e-15, 1e-9, 1e3, 1e3), "nano": (1e-21, 1e-9, 1e-9, 1e-21, 1e-12, 1e6, 1e6)}
