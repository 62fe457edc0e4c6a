/* SPH-TM: where the loops over particles run and where their arrays live.

   The host's, or that of Kokkos on threads or a GPU (backend_kokkos.h). What runs there stands in the loop tables of
   the packages (loop_table.h). */
#ifndef SPHTM_BACKEND_H
#define SPHTM_BACKEND_H

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace SPHTM_NS {

constexpr int LOOP_BLOCK = 8 * 96;    // particles; a multiple of the host's TM_CHUNK

class Backend {
 public:
  static Backend &host();
  virtual ~Backend() = default;
  virtual std::string name() const;    // for the log

  // memory of the loops; shared: it is the host's
  virtual bool shared() const { return true; }
  virtual int block() const { return 1; }                                      // particles of a block, see tm_layout.h
  virtual void *allocate(size_t, const char * /*what*/) { return nullptr; }    // what: for tables of memory
  virtual void release(void *) {}
  virtual double free_memory() const { return 1e300; }    // bytes of it that are not in use, where that is known
  virtual void to_loops(void * /*there*/, const void * /*here*/, size_t) {}
  virtual void to_host(void * /*here*/, const void * /*there*/, size_t) {}
  virtual void copy(void *to, const void *from, size_t bytes);    // within it
  virtual void zero(void *, size_t bytes);
  virtual void fill(unsigned char *, unsigned char value, size_t n);
  virtual void wait() {}    // until all loops are done

  // loops that are no loops of the host: the particles among the first n that they run over, and how many; nullptr: all
  virtual const int *some(int & /*n*/) const { return nullptr; }

  // times of loops that are not waited for: mark number k lies behind all loops so far; the time between two marks waits
  // for the second
  virtual void mark(int /*k*/) {}
  virtual double seconds_between(int /*first*/, int /*second*/) { return 0.0; }

  // for results of loops that are not waited for: memory that host and loops see
  virtual void *allocate_result(size_t);
  virtual void release_result(void *);
  virtual void copy_to_result(void *result, const void *of_loops, size_t bytes);    // not waited for either

  // loops on the host: f(begin, end) for the blocks that make up 0..n-1
  virtual void blocks(int n, const std::function<void(int, int)> &f);

  // the sum of part(begin, end) over the blocks
  template <class RESULT, class PART, class JOIN> RESULT sum_blocks(int n, const RESULT &nothing, PART part, JOIN join)
  {
    std::vector<RESULT> parts((n + LOOP_BLOCK - 1) / LOOP_BLOCK, nothing);
    blocks(n, [&](int begin, int end) {    // one thread has all parts of a block
      const RESULT sum = part(begin, end);
      join(&parts[begin / LOOP_BLOCK], &sum);
    });
    RESULT sum = nothing;
    for (const RESULT &p : parts) join(&sum, &p);
    return sum;
  }
};

}    // namespace SPHTM_NS

#endif
