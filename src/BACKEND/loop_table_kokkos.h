/* SPH-TM: the loops of a table (loop_table.h) as kernels of Kokkos; those of kinds RANGE and OWN are written by hand. */
#ifndef SPHTM_LOOP_TABLE_KOKKOS_H
#define SPHTM_LOOP_TABLE_KOKKOS_H

#include "backend_kokkos.h"
#include "loop_table.h"

#define SPHTM_KOKKOS_LOOP(KIND, ...) SPHTM_KOKKOS_##KIND(__VA_ARGS__)
#define SPHTM_KOKKOS_EACH(NAME, ARGS, ...)                                          \
  struct NAME##_kernel {                                                            \
    ARGS a;                                                                         \
    unsigned effects;                                                               \
    KOKKOS_FUNCTION void operator()(int i) const { __VA_ARGS__; }                   \
  };                                                                                \
  void NAME(Backend &b, int n, const ARGS &a, unsigned effects)                     \
  {                                                                                 \
    kokkos_each("sph/tm " #NAME, KokkosParticles(b, n), NAME##_kernel{a, effects}); \
  }
#define SPHTM_KOKKOS_SUM(NAME, ARGS, RESULT, FAMILY, ...)                                                    \
  struct NAME##_kernel {                                                                                     \
    ARGS a;                                                                                                  \
    unsigned effects;                                                                                        \
    KOKKOS_FUNCTION RESULT operator()(int i) const { return __VA_ARGS__; }                                   \
  };                                                                                                         \
  struct NAME##_add {                                                                                        \
    KOKKOS_FUNCTION void operator()(RESULT *sum, const RESULT *value) const { FAMILY##_sum(sum, value); }    \
  };                                                                                                         \
  RESULT NAME(Backend &b, int n, const ARGS &a, unsigned effects)                                            \
  {                                                                                                          \
    return kokkos_sum("sph/tm " #NAME, KokkosParticles(b, n), FAMILY##_nothing(), NAME##_kernel{a, effects}, \
                      NAME##_add());                                                                         \
  }
#define SPHTM_KOKKOS_LIST(NAME, ARGS, ...)                               \
  struct NAME##_takes {                                                  \
    ARGS a;                                                              \
    KOKKOS_FUNCTION bool operator()(int i) const { return __VA_ARGS__; } \
  };                                                                     \
  int NAME(Backend &, int n, const ARGS &a, int *list)                   \
  {                                                                      \
    return kokkos_list("sph/tm " #NAME, n, NAME##_takes{a}, list);       \
  }
#define SPHTM_KOKKOS_HOT_EACH SPHTM_KOKKOS_EACH
#define SPHTM_KOKKOS_HOT_SUM SPHTM_KOKKOS_SUM
#define SPHTM_KOKKOS_RANGE(...)
#define SPHTM_KOKKOS_RANGE_SUM(...)
#define SPHTM_KOKKOS_OWN(...)

#endif
