/* SPH-TM: tables of loops over particles.

   A package lists its loops once, one line each, in a macro LOOPS(LOOP); the pointers of its table, the loops of the
   host and those of Kokkos are made from that list:

     LOOP(EACH, name, arguments, expression)
         expression for particle i, where a holds the arguments and effects the effect bits
     LOOP(SUM, name, arguments, result, family, expression)
         the sum of the expression over particles; family_nothing() is the empty sum, family_sum(&sum, &value) adds
     LOOP(HOT_EACH, ...), LOOP(HOT_SUM, ...)
         the same, and on the host compiled for each instruction set (instruction_set.h)
     LOOP(RANGE, name, arguments), LOOP(RANGE_SUM, name, arguments, result, family)
         as these, but what runs particles begin to end - 1 is written by hand for each instruction set, and for Kokkos:
         for loops that are instantiated for sets of effects
     LOOP(LIST, name, arguments, expression)
         a list of the particles for which the expression holds, in rising order
     LOOP(OWN, name, result, parameters)
         written by hand for the host and for Kokkos

   All are called as table.name(backend, n, arguments, effects) for particles 0 to n - 1, those of kind OWN with their
   parameters behind the backend, those of kind LIST as table.name(backend, n, arguments, list), which returns the length
   of the list. A package has these files in its folder loops:

     x_loops.h         the list and   struct XLoops { SPHTM_LOOP_POINTERS(X_LOOPS) ... };
     x_loops.cpp       namespace { loops of kind OWN; X_LOOPS(SPHTM_HOST_LOOP) }  and the table {X_LOOPS(SPHTM_LOOP_NAME)}
     x_loops_kokkos.cpp    the same with SPHTM_KOKKOS_LOOP of loop_table_kokkos.h
     x_ranges.h        where there are hot loops: included once per instruction set

   Sums run over blocks of particles and then over the blocks, so that they do not depend on the number of threads. */
#ifndef SPHTM_LOOP_TABLE_H
#define SPHTM_LOOP_TABLE_H

#include "backend.h"
#include "instruction_set.h"

// ---- pointers of a table

#define SPHTM_LOOP_POINTER(KIND, ...) SPHTM_POINTER_##KIND(__VA_ARGS__)
#define SPHTM_LOOP_POINTERS(LOOPS) LOOPS(SPHTM_LOOP_POINTER)
#define SPHTM_POINTER_EACH(NAME, ARGS, ...) void (*NAME)(Backend &, int n, const ARGS &, unsigned effects);
#define SPHTM_POINTER_SUM(NAME, ARGS, RESULT, ...) RESULT (*NAME)(Backend &, int n, const ARGS &, unsigned effects);
#define SPHTM_POINTER_HOT_EACH SPHTM_POINTER_EACH
#define SPHTM_POINTER_HOT_SUM SPHTM_POINTER_SUM
#define SPHTM_POINTER_RANGE SPHTM_POINTER_EACH
#define SPHTM_POINTER_RANGE_SUM SPHTM_POINTER_SUM
#define SPHTM_POINTER_LIST(NAME, ARGS, ...) int (*NAME)(Backend &, int n, const ARGS &, int *list);
#define SPHTM_POINTER_OWN(NAME, RESULT, ...) RESULT (*NAME)(Backend &, __VA_ARGS__);

#define SPHTM_LOOP_NAME(KIND, NAME, ...) NAME,

// ---- loops of the host. Those of kinds HOT and RANGE need a function ranges() that returns the table of ranges

#define SPHTM_HOST_LOOP(KIND, ...) SPHTM_HOST_##KIND(__VA_ARGS__)
#define SPHTM_HOST_EACH(NAME, ARGS, ...)                              \
  void NAME(Backend &backend, int n, const ARGS &a, unsigned effects) \
  {                                                                   \
    (void) effects;                                                   \
    backend.blocks(n, [&](int begin, int end) {                       \
      for (int i = begin; i < end; i++) { __VA_ARGS__; }              \
    });                                                               \
  }
#define SPHTM_HOST_SUM(NAME, ARGS, RESULT, FAMILY, ...)                      \
  RESULT NAME(Backend &backend, int n, const ARGS &a, unsigned effects)      \
  {                                                                          \
    (void) effects;                                                          \
    return backend.sum_blocks(                                               \
        n, FAMILY##_nothing(),                                               \
        [&](int begin, int end) {                                            \
          RESULT sum = FAMILY##_nothing();                                   \
          for (int i = begin; i < end; i++) {                                \
            const RESULT value = __VA_ARGS__;                                \
            FAMILY##_sum(&sum, &value);                                      \
          }                                                                  \
          return sum;                                                        \
        },                                                                   \
        [](RESULT *sum, const RESULT *value) { FAMILY##_sum(sum, value); }); \
  }
#define SPHTM_HOST_RANGE(NAME, ARGS)                                                \
  void NAME(Backend &backend, int n, const ARGS &a, unsigned effects)               \
  {                                                                                 \
    const auto range = ranges().NAME;                                               \
    backend.blocks(n, [&](int begin, int end) { range(begin, end, &a, effects); }); \
  }
#define SPHTM_HOST_RANGE_SUM(NAME, ARGS, RESULT, FAMILY)                                           \
  RESULT NAME(Backend &backend, int n, const ARGS &a, unsigned effects)                            \
  {                                                                                                \
    const auto range = ranges().NAME;                                                              \
    return backend.sum_blocks(                                                                     \
        n, FAMILY##_nothing(), [&](int begin, int end) { return range(begin, end, &a, effects); }, \
        [](RESULT *sum, const RESULT *value) { FAMILY##_sum(sum, value); });                       \
  }
#define SPHTM_HOST_HOT_EACH(NAME, ARGS, ...) SPHTM_HOST_RANGE(NAME, ARGS)
#define SPHTM_HOST_HOT_SUM(NAME, ARGS, RESULT, FAMILY, ...) SPHTM_HOST_RANGE_SUM(NAME, ARGS, RESULT, FAMILY)
#define SPHTM_HOST_LIST(NAME, ARGS, ...)               \
  int NAME(Backend &, int n, const ARGS &a, int *list) \
  {                                                    \
    int m = 0;                                         \
    for (int i = 0; i < n; i++)                        \
      if (__VA_ARGS__) list[m++] = i;                  \
    return m;                                          \
  }
#define SPHTM_HOST_OWN(...)

// ---- ranges of particles, for one instruction set: pointers, the functions of kind HOT, names

#define SPHTM_RANGE_POINTER(KIND, ...) SPHTM_RANGE_POINTER_##KIND(__VA_ARGS__)
#define SPHTM_RANGE_POINTERS(LOOPS) LOOPS(SPHTM_RANGE_POINTER)
#define SPHTM_RANGE_POINTER_EACH(...)
#define SPHTM_RANGE_POINTER_SUM(...)
#define SPHTM_RANGE_POINTER_LIST(...)
#define SPHTM_RANGE_POINTER_OWN(...)
#define SPHTM_RANGE_POINTER_RANGE(NAME, ARGS, ...) void (*NAME)(int begin, int end, const ARGS *, unsigned effects);
#define SPHTM_RANGE_POINTER_RANGE_SUM(NAME, ARGS, RESULT, ...) \
  RESULT (*NAME)(int begin, int end, const ARGS *, unsigned effects);
#define SPHTM_RANGE_POINTER_HOT_EACH SPHTM_RANGE_POINTER_RANGE
#define SPHTM_RANGE_POINTER_HOT_SUM SPHTM_RANGE_POINTER_RANGE_SUM

#define SPHTM_RANGE_LOOP(KIND, ...) SPHTM_RANGE_LOOP_##KIND(__VA_ARGS__)
#define SPHTM_RANGE_LOOP_EACH(...)
#define SPHTM_RANGE_LOOP_SUM(...)
#define SPHTM_RANGE_LOOP_LIST(...)
#define SPHTM_RANGE_LOOP_OWN(...)
#define SPHTM_RANGE_LOOP_RANGE(...)
#define SPHTM_RANGE_LOOP_RANGE_SUM(...)
#define SPHTM_RANGE_LOOP_HOT_EACH(NAME, ARGS, ...)                  \
  void NAME(int begin, int end, const ARGS *args, unsigned effects) \
  {                                                                 \
    const ARGS &a = *args;                                          \
    (void) effects;                                                 \
    for (int i = begin; i < end; i++) { __VA_ARGS__; }              \
  }
#define SPHTM_RANGE_LOOP_HOT_SUM(NAME, ARGS, RESULT, FAMILY, ...)     \
  RESULT NAME(int begin, int end, const ARGS *args, unsigned effects) \
  {                                                                   \
    const ARGS &a = *args;                                            \
    (void) effects;                                                   \
    RESULT sum = FAMILY##_nothing();                                  \
    for (int i = begin; i < end; i++) {                               \
      const RESULT value = __VA_ARGS__;                               \
      FAMILY##_sum(&sum, &value);                                     \
    }                                                                 \
    return sum;                                                       \
  }

#define SPHTM_RANGE_NAME(KIND, ...) SPHTM_RANGE_NAME_##KIND(__VA_ARGS__)
#define SPHTM_RANGE_NAME_EACH(...)
#define SPHTM_RANGE_NAME_SUM(...)
#define SPHTM_RANGE_NAME_LIST(...)
#define SPHTM_RANGE_NAME_OWN(...)
#define SPHTM_RANGE_NAME_RANGE(NAME, ...) NAME,
#define SPHTM_RANGE_NAME_RANGE_SUM(NAME, ...) NAME,
#define SPHTM_RANGE_NAME_HOT_EACH(NAME, ...) NAME,
#define SPHTM_RANGE_NAME_HOT_SUM(NAME, ...) NAME,

#endif
