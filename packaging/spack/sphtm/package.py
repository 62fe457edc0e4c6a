"""Spack recipe. Not tried: written against Spack's documented interface, where there was no Spack to run it.

    spack repo create sphtm-repo && cp -r packaging/spack/sphtm sphtm-repo/packages/
    spack repo add sphtm-repo
    spack install sphtm
    spack load sphtm && sphtm doctor

There is no archive to download: `git` below is where the repository is, to be filled in."""
from spack.package import *


class Sphtm(CMakePackage):
    """Thermo-mechanical smoothed particle hydrodynamics for metal cutting, a plugin for LAMMPS."""

    homepage = "https://www.lammps.org"
    git = "file:///path/to/sphtm"    # fill in
    license("GPL-2.0-only")

    version("main", branch="main")

    variant("python", default=True, description="what demonstration and studies need")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.20:", type="build")
    # a plugin fits one version of LAMMPS; 4 Feb 2025 is the one that all tests are of
    depends_on("lammps@20250204 +plugin+lib+mpi", type=("build", "link", "run"))
    depends_on("mpi")
    with when("+python"):
        depends_on("python@3.9:", type="run")
        depends_on("py-numpy", type="run")
        depends_on("py-scipy", type="run")
        depends_on("py-matplotlib", type="run")

    # an installed LAMMPS has only some of the headers: the source of the same release has all
    resource(
        name="lammps-source",
        git="https://github.com/lammps/lammps.git",
        tag="patch_4Feb2025",
        placement="lammps-source",
    )

    def cmake_args(self):
        return [
            self.define("LAMMPS_SOURCE_DIR", join_path(self.stage.source_path, "lammps-source", "src")),
            self.define("LAMMPS_BUILD_DIR", self.spec["lammps"].prefix),
            self.define("SPHTM_TESTS", False),
        ]

    def setup_run_environment(self, env):
        env.prepend_path("LAMMPS_PLUGIN_PATH", self.prefix.lib.lammps.plugins)
        env.set("SPHTM_LMP", self.spec["lammps"].prefix.bin.lmp)
