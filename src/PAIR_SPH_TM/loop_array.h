/* SPH-TM: an array of the particle loops. Where the loops have a memory of their own it exists there
   and, once the host has asked for it, here too; each side is brought up to date when it is used. */
#ifndef SPHTM_LOOP_ARRAY_H
#define SPHTM_LOOP_ARRAY_H

#include "backend.h"

#include <algorithm>
#include <vector>

namespace SPHTM_NS {

template <class T> class LoopArray {
 public:
  LoopArray() = default;
  explicit LoopArray(Backend &b) : backend(&b) {}
  LoopArray(const LoopArray &) = delete;
  LoopArray &operator=(const LoopArray &) = delete;
  ~LoopArray() { clear(); }

  void live_in(Backend &b)
  {
    clear();
    backend = &b;
  }
  // the same values, elsewhere
  void move_to(Backend &b)
  {
    if (&b == backend) return;
    const T *from = host_read();
    const std::vector<T> values(from, from + count);
    live_in(b);
    if (!values.empty()) assign(values.data(), values.size());
  }
  size_t size() const { return count; }
  bool empty() const { return count == 0; }
  size_t bytes() const { return count * sizeof(T); }

  void clear()
  {
    std::vector<T>().swap(here);
    backend->release(there);
    there = nullptr;
    count = 0;
    newest = BOTH;
  }
  // keeps the values, new ones are 0
  void resize(size_t n)
  {
    if (n <= count) return;
    if (backend->shared()) here.resize(n);
    else {
      loop_read();
      T *p = (T *) backend->allocate(n * sizeof(T));
      if (count) backend->copy(p, there, bytes());
      backend->zero(p + count, (n - count) * sizeof(T));
      backend->release(there);
      there = p;
      newest = LOOPS;
    }
    count = n;
  }
  // room for n values whatever they are, or none
  void make_room(bool wanted, size_t n)
  {
    if (wanted ? n <= count : empty()) return;
    clear();
    if (wanted) resize(n + n / 8);
  }
  // these values
  void assign(const T *values, size_t n)
  {
    if (n != count) clear();
    resize(n);
    std::copy_n(values, n, host_write());
  }

  // current values, or a null pointer; who takes it to write changes them, until the other side takes one
  const T *loop_read()
  {
    if (!count) return nullptr;
    if (backend->shared()) return here.data();
    if (newest == HOST) {
      backend->to_loops(there, here.data(), bytes());
      newest = BOTH;
    }
    return there;
  }
  T *loop_write()
  {
    T *p = const_cast<T *>(loop_read());
    if (there) newest = LOOPS;
    return p;
  }
  const T *host_read()
  {
    if (!count) return nullptr;
    if (!backend->shared()) {
      here.resize(count);
      if (newest == LOOPS) backend->to_host(here.data(), there, bytes());
      if (newest == LOOPS) newest = BOTH;
    }
    return here.data();
  }
  T *host_write()
  {
    T *p = const_cast<T *>(host_read());
    if (there) newest = HOST;
    return p;
  }

 private:
  Backend *backend = &Backend::host();
  std::vector<T> here;
  T *there = nullptr;
  size_t count = 0;
  enum { BOTH, HOST, LOOPS } newest = BOTH;    // where the newest values are
};

}    // namespace SPHTM_NS

#endif
