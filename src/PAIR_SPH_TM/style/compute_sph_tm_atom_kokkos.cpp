/* SPH-TM: compute sph/tm/atom with Kokkos. See doc/compute_sph_tm_atom.rst. */
#ifdef LMP_KOKKOS
#include "compute_sph_tm_atom_kokkos.h"

#include "backend_kokkos.h"

#include "atom_kokkos.h"
#include "kokkos.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

namespace {

struct Values {
  tm_output_args a;
  KOKKOS_FUNCTION void operator()(int i) const { tm_output(i, &a); }
};

}    // namespace

ComputeSPHTMAtomKokkos::ComputeSPHTMAtomKokkos(LAMMPS *lmp, int narg, char **arg) :
    ComputeSPHTMAtom(lmp, narg, arg), columns(kokkos_backend()), values(kokkos_backend())
{
}

void ComputeSPHTMAtomKokkos::run_output(double *value)
{
  if (state->loops().shared()) ComputeSPHTMAtom::run_output(value);
  else state->loops().to_host(value, make_values(), (size_t) atom->nlocal * wanted.size() * sizeof(double));
}

const double *ComputeSPHTMAtomKokkos::values_of_loops(int &n)
{
  check_current();
  n = (int) wanted.size();
  return state->loops().shared() || wants(TM_OUT_LEVEL) ? nullptr : make_values();
}

const double *ComputeSPHTMAtomKokkos::make_values()
{
  // Between steps LAMMPS lets a host's fix take the atoms for the host's, and would copy them all to the GPU before
  // each look at them. During a run both sides are marked where they are newer.
  const int automatic = lmp->kokkos->auto_sync;
  if (update->whichflag && !update->setupflag) lmp->kokkos->auto_sync = 0;
  tm_output_args a = output_args();
  lmp->kokkos->auto_sync = automatic;
  columns.assign(wanted.data(), wanted.size());
  values.make_room(true, (size_t) atom->nlocal * a.columns + 1);
  a.wanted = columns.loop_read();
  a.value = values.loop_write();
  kokkos_each("sph/tm output", atom->nlocal, Values{a});
  return a.value;
}
#endif
