#include "backend.h"

#include "instruction_set.h"

#include <algorithm>
#include <cstring>
#include <new>

namespace SPHTM_NS {

Backend &Backend::host()
{
  static Backend backend;
  return backend;
}

std::string Backend::name() const { return instruction_set_name(); }

void Backend::copy(void *to, const void *from, size_t bytes)
{
  if (bytes) memcpy(to, from, bytes);    // pointers to nothing may be null
}

void Backend::zero(void *p, size_t bytes)
{
  if (bytes) memset(p, 0, bytes);
}

void Backend::fill(unsigned char *p, unsigned char value, size_t n)
{
  if (n) memset(p, value, n);
}

void Backend::blocks(int n, const std::function<void(int, int)> &f)
{
  for (int begin = 0; begin < n; begin += LOOP_BLOCK) f(begin, std::min(n, begin + LOOP_BLOCK));
}

void *Backend::allocate_result(size_t bytes) { return ::operator new(bytes); }
void Backend::release_result(void *p) { ::operator delete(p); }
void Backend::copy_to_result(void *result, const void *of_loops, size_t bytes) { memcpy(result, of_loops, bytes); }

}    // namespace SPHTM_NS
