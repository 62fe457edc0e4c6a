/* SPH-TM: fix contact/tri with Kokkos. See doc/fix_contact_tri.rst. */
#ifdef LMP_KOKKOS
#include "fix_contact_tri_kokkos.h"

#include "backend_kokkos.h"
#include "fix_sph_tm.h"

#include "atom_kokkos.h"
#include "atom_masks.h"

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

FixContactTriKokkos::FixContactTriKokkos(LAMMPS *lmp, int narg, char **arg) : FixContactTri(lmp, narg, arg)
{
  kokkosable = 1;
  atomKK = (AtomKokkos *) atom;
  execution_space = ExecutionSpaceFromDevice<LMPDeviceType>::space;
  datamask_read = X_MASK | V_MASK | F_MASK | TYPE_MASK | MASK_MASK | RMASS_MASK;
  datamask_modify = F_MASK;
  if (request.body_type) datamask_modify |= X_MASK | V_MASK;
  forward_comm_device = 1;
}

FixContactTriKokkos::~FixContactTriKokkos()
{
  if (!copymode && owner) owner->release_result(result);
}

void FixContactTriKokkos::init()
{
  atomKK->sync(Host, TYPE_MASK | MASK_MASK);    // which types it can touch
  FixContactTri::init();
  if (owner) return;
  owner = &state->loops();
  result = (tm_contact_result *) owner->allocate_result(sizeof(tm_contact_result));
}

// the look for overlaps at the start is the host's
void FixContactTriKokkos::setup(int vflag)
{
  atomKK->sync(Host, ALL_MASK);
  FixContactTri::setup(vflag);
}

namespace {

// effects as literals, or all tested at run time
template <unsigned EFFECTS, bool ANY> struct Contact {
  tm_contact_args a;
  unsigned fx;
  KOKKOS_FUNCTION tm_contact_result operator()(int i) const { return tm_contact_tri(i, &a, ANY ? fx : EFFECTS); }
};
struct SumContact {
  KOKKOS_FUNCTION void operator()(tm_contact_result *sum, const tm_contact_result *r) const
  {
    if (r->depth > 0.0) tm_contact_sum(sum, r);
  }
};
template <unsigned EFFECTS, bool ANY = false>
void contact_kernel(int n, const tm_contact_args &a, unsigned fx, tm_contact_result *result)
{
  using Bounds = Kokkos::LaunchBounds<128, 4>;    // few particles touch: the others should not wait for registers
  kokkos_sum_later<Bounds>("contact/tri", n, tm_contact_nothing(), Contact<EFFECTS, ANY>{a, fx}, SumContact(), result);
}

struct Divide {
  tm_spread_args a;
  int n;
  KOKKOS_FUNCTION int operator()(int i) const { return tm_spread_divide(i, &a) ? i : n; }
};
struct Least {
  KOKKOS_FUNCTION void operator()(int *least, const int *i) const { *least = *i < *least ? *i : *least; }
};
struct Collect {
  tm_spread_args a;
  KOKKOS_FUNCTION void operator()(int j) const { tm_spread_collect(j, &a); }
};
struct PackHeat {
  const double *heat;
  const int *list;
  double *buf;
  KOKKOS_FUNCTION void operator()(int k) const { buf[k] = heat[list[k]]; }
};
struct UnpackHeat {
  double *heat;
  const double *buf;
  KOKKOS_FUNCTION void operator()(int k) const { heat[k] = buf[k]; }
};

struct Carry {
  tm_carry_args a;
  KOKKOS_FUNCTION void operator()(int i) const { tm_carry(i, &a); }
};

}    // namespace

void FixContactTriKokkos::start_contact(const tm_contact_args &a, unsigned fx)
{
  constexpr unsigned D = TM_CT_3D, H = TM_CT_HEAT, F = TM_CT_FRICTION;
  if (state->loops().shared()) {
    FixContactTri::start_contact(a, fx);
    return;
  }
  const int n = atom->nlocal;
  switch (fx) {
    case F: contact_kernel<F>(n, a, fx, result); break;
    case H | F: contact_kernel<H | F>(n, a, fx, result); break;
    case D | F: contact_kernel<D | F>(n, a, fx, result); break;
    case D | H | F: contact_kernel<D | H | F>(n, a, fx, result); break;
    default: contact_kernel<0, true>(n, a, fx, result); break;
  }
}

void FixContactTriKokkos::wait_for_contact()
{
  if (state->loops().shared()) return;
  state->loops().wait();
  sums = *result;
}

void FixContactTriKokkos::run_carry(const tm_carry_args &a)
{
  if (state->loops().shared()) FixContactTri::run_carry(a);
  else kokkos_each("contact/tri carry", atom->nlocal, Carry{a});
}

int FixContactTriKokkos::run_divide(const tm_spread_args &a)
{
  if (state->loops().shared()) return FixContactTri::run_divide(a);
  const int n = atom->nlocal;
  return kokkos_sum("contact/tri divide heat", n, n, Divide{a, n}, Least());
}

void FixContactTriKokkos::run_collect(const tm_spread_args &a)
{
  if (state->loops().shared()) FixContactTri::run_collect(a);
  else kokkos_each("contact/tri collect heat", atom->nlocal, Collect{a});
}

int FixContactTriKokkos::pack_forward_comm_kokkos(int n, DAT::tdual_int_1d k_sendlist, DAT::tdual_xfloat_1d &buf, int,
                                                  int *)
{
  kokkos_each("contact/tri send heat", n, PackHeat{tool_heat.loop_read(), k_sendlist.view<LMPDeviceType>().data(),
                                                   buf.view<LMPDeviceType>().data()});
  return n;
}

void FixContactTriKokkos::unpack_forward_comm_kokkos(int n, int first, DAT::tdual_xfloat_1d &buf)
{
  kokkos_each("contact/tri receive heat", n,
              UnpackHeat{tool_heat.loop_write() + first, buf.view<LMPDeviceType>().data()});
}
#endif
