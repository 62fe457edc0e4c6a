/* SPH-TM: an array of the particle loops. Where the loops have a memory of their own it exists there
   and, once the host has asked for it, here too; each side is brought up to date when it is used. On
   the host the columns of a particle always lie together; there, as tm_layout.h says. */
#ifndef SPHTM_LOOP_ARRAY_H
#define SPHTM_LOOP_ARRAY_H

#include "aligned_memory.h"
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

  // rows of so many columns; records keep two together
  void live_in(Backend &b, int columns_ = 1, int together_ = 1)
  {
    clear();
    backend = &b;
    columns = columns_;
    together = together_;
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
  void call(const char *what) { name = what; }    // in tables of memory
  size_t size() const { return count; }
  bool empty() const { return count == 0; }
  size_t bytes() const { return count * sizeof(T); }

  void clear()
  {
    Values().swap(here);
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
      const size_t old = room(count), now = room(n);
      T *p = (T *) backend->allocate(now * sizeof(T), name);
      if (count) backend->copy(p, there, old * sizeof(T));
      backend->zero(p + old, (now - old) * sizeof(T));
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
      push();
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
      if (newest == LOOPS) pull();
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
  using Values = std::vector<T, AlignedMemory<T>>;
  Values here;
  T *there = nullptr;
  size_t count = 0;
  int columns = 1, together = 1;
  const char *name = "other";

  // places there: whole blocks
  bool blocks() const { return backend->block() > 1 && columns > together; }
  size_t room(size_t n) const
  {
    const size_t block = (size_t) (blocks() ? backend->block() : 1) * columns;
    return blocks() ? (n + block - 1) / block * block : n;
  }
  size_t place(size_t k) const
  {
    const size_t block = backend->block(), i = k / columns, c = k % columns;
    return i / block * (block * columns) + c / together * (together * block) + i % block * together + c % together;
  }
  void push()
  {
    if (!blocks()) {
      backend->to_loops(there, here.data(), bytes());
      return;
    }
    std::vector<T> placed(room(count));
    for (size_t k = 0; k < count; k++) placed[place(k)] = here[k];
    backend->to_loops(there, placed.data(), placed.size() * sizeof(T));
  }
  void pull()
  {
    if (!blocks()) {
      backend->to_host(here.data(), there, bytes());
      return;
    }
    std::vector<T> placed(room(count));
    backend->to_host(placed.data(), there, placed.size() * sizeof(T));
    for (size_t k = 0; k < count; k++) here[k] = placed[place(k)];
  }
  enum { BOTH, HOST, LOOPS } newest = BOTH;    // where the newest values are
};

}    // namespace SPHTM_NS

#endif
