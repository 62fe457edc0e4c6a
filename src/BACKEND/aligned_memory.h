/* SPH-TM: memory of the host for arrays of the particle loops. Records begin at a cache line, so none lies in one more
   than it must; large arrays are asked for in huge pages, as rows of neighbors lie so far apart that each would need
   page entries of its own. */
#ifndef SPHTM_ALIGNED_MEMORY_H
#define SPHTM_ALIGNED_MEMORY_H

#include <cstddef>
#include <cstdlib>
#include <new>
#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace SPHTM_NS {

template <class T> struct AlignedMemory {
  using value_type = T;
  static constexpr size_t LINE = 64, PAGE = 2 << 20;    // bytes

  AlignedMemory() = default;
  template <class U> AlignedMemory(const AlignedMemory<U> &) {}
  T *allocate(size_t n)
  {
    const size_t align = n * sizeof(T) >= 2 * PAGE ? PAGE : LINE;
    const size_t bytes = (n * sizeof(T) + align - 1) / align * align;
    void *p = std::aligned_alloc(align, bytes);
    if (!p) throw std::bad_alloc();
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    if (align == PAGE) madvise(p, bytes, MADV_HUGEPAGE);    // refused: pages of the usual size
#endif
    return (T *) p;
  }
  void deallocate(T *p, size_t) { std::free(p); }
  bool operator==(const AlignedMemory &) const { return true; }
  bool operator!=(const AlignedMemory &) const { return false; }
};

}    // namespace SPHTM_NS

#endif
