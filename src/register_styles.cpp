/* SPH-TM: registers all styles. sphtmplugin.cpp loads what this is in once it knows that LAMMPS fits. */
#include "style_registry.h"

#include "compute_cutting_force.h"
#include "compute_sph_tm_atom.h"
#include "dump_sph_tm_vtp.h"
#include "fix_adapt_neigh.h"
#include "fix_contact_tri.h"
#include "fix_sph_tm.h"
#include "fix_sph_tm_drive.h"
#include "fix_sph_tm_heat.h"
#include "fix_sph_tm_relax.h"
#include "pair_sph_tm.h"
#ifdef LMP_KOKKOS
#include "compute_reduce_kokkos.h"
#include "compute_sph_tm_atom_kokkos.h"
#include "fix_adapt_neigh_kokkos.h"
#include "fix_contact_tri_kokkos.h"
#include "fix_setforce_later_kokkos.h"
#include "fix_sph_tm_kokkos.h"
#include "fixes_of_host_kokkos.h"
#include "on_loops_kokkos.h"
#include "pair_sph_tm_kokkos.h"

#include "fix_ave_time.h"
#include "fix_halt.h"
#include "fix_print.h"
#include "fix_vector.h"
#endif

using namespace LAMMPS_NS;

#ifdef LMP_KOKKOS
using PairKokkos = PairSPHTMKokkos;
using FixKokkos = FixSPHTMKokkos;
using ContactKokkos = FixContactTriKokkos;
using AdaptKokkos = FixAdaptNeighKokkos;
using HeatKokkos = SPHTM_NS::OnLoopsKokkos<FixSPHTMHeat>;
using DriveKokkos = SPHTM_NS::OnLoopsKokkos<FixSPHTMDrive>;
using RelaxKokkos = SPHTM_NS::OnLoopsKokkos<FixSPHTMRelax>;
using AtomComputeKokkos = ComputeSPHTMAtomKokkos;
#else
using PairKokkos = PairSPHTM;
using FixKokkos = FixSPHTM;
using ContactKokkos = FixContactTri;
using AdaptKokkos = FixAdaptNeigh;
using HeatKokkos = FixSPHTMHeat;
using DriveKokkos = FixSPHTMDrive;
using RelaxKokkos = FixSPHTMRelax;
using AtomComputeKokkos = ComputeSPHTMAtom;
#endif

extern "C" __attribute__((visibility("default"))) void sphtm_register_styles(void *ptr, void *handle, void *regfunc)
{
  SPHTM_NS::Registry registry(ptr, handle, regfunc);
  registry.pair<PairSPHTM, PairKokkos>("sph/tm", "thermo-mechanical SPH of solids");
  registry.state_fix<FixSPHTM, FixKokkos>("sph/tm", "state and time integration of pair sph/tm");
  registry.fix<FixSPHTMHeat, HeatKokkos>("sph/tm/heat", "temperature, flux, source, convection, radiation on a group");
  registry.fix<FixSPHTMDrive, DriveKokkos>("sph/tm/drive", "prescribed velocity of a group of sph/tm particles");
  registry.fix<FixSPHTMRelax, RelaxKokkos>("sph/tm/relax", "damping of a group to its static equilibrium");
  registry.compute<ComputeSPHTMAtom, AtomComputeKokkos>("sph/tm/atom", "per-particle values of sph/tm");
  registry.fix<FixContactTri, ContactKokkos>("contact/tri", "contact, friction and heat with a tool of triangles");
  registry.state_fix<FixAdaptNeigh, AdaptKokkos>("adapt/neigh",
                                                 "what follows the deformation: lists, smoothing length, refinement");
#ifdef LMP_KOKKOS
  const char *const without = "without particles on the host where none are needed";
  registry.kokkos_fix<SPHTM_NS::FixOfHostKokkos<FixAveTime>>("ave/time", without);
  registry.kokkos_fix<SPHTM_NS::FixOfHostKokkos<FixHalt>>("halt", without);
  registry.kokkos_fix<SPHTM_NS::FixOfHostKokkos<FixPrint>>("print", without);
  registry.kokkos_fix<SPHTM_NS::FixOfHostKokkos<FixVector>>("vector", without);
  registry.kokkos_compute<ComputeReduceKokkos>("reduce", without);
  registry.in_place_of_kokkos_fix<FixSetForceLaterKokkos>("setforce");
#endif
  registry.dump<DumpSPHTMVtp>("sph/tm/vtp");
  registry.compute<ComputeCuttingForce>("cutting/force", "forces of a tool in terms of cutting");
}
