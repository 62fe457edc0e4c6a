#include "particle_fields.h"

#include <algorithm>

namespace SPHTM_NS {

ParticleFields::ParticleFields(Backend &backend)
{
  for (int id = 0; id < TM_F_COUNT; id++) {
    values[id].live_in(backend, tm_field_table[id].columns);
    values[id].call(tm_field_table[id].name);
  }
}

unsigned ParticleFields::needed(unsigned effects)
{
  unsigned mask = 0;
  for (int id = 0; id < TM_F_COUNT; id++)
    if (!tm_field_table[id].effects || (tm_field_table[id].effects & effects)) mask |= 1u << id;
  return mask;
}

unsigned ParticleFields::enable(unsigned effects, int nmax)
{
  enable_mask(needed(effects), nmax);
  return used;
}

void ParticleFields::enable_mask(unsigned mask, int nmax)
{
  used = mask;
  width = 0;
  for (int id = 0; id < TM_F_COUNT; id++) {
    if (!(used & (1u << id))) {
      values[id].clear();
      continue;
    }
    width += tm_field_table[id].columns;
  }
  grow(std::max(nmax, 1));
}

void ParticleFields::grow(int nmax)
{
  rows = std::max(rows, nmax);
  for (int id = 0; id < TM_F_COUNT; id++)
    if (used & (1u << id)) values[id].resize((size_t) rows * tm_field_table[id].columns);
}

void ParticleFields::copy(int from, int to)
{
  for (int id = 0; id < TM_F_COUNT; id++) {
    if (!(used & (1u << id))) continue;
    const size_t n = tm_field_table[id].columns;
    double *row = values[id].host_write();
    std::copy_n(row + from * n, n, row + to * n);
  }
}

void ParticleFields::zero(int i)
{
  for (int id = 0; id < TM_F_COUNT; id++) {
    if (!(used & (1u << id))) continue;
    const size_t n = tm_field_table[id].columns;
    std::fill_n(values[id].host_write() + i * n, n, 0.0);
  }
}

int ParticleFields::pack(int i, double *buf)
{
  int m = 0;
  for (int id = 0; id < TM_F_COUNT; id++) {
    if (!(used & (1u << id))) continue;
    const size_t n = tm_field_table[id].columns;
    std::copy_n(values[id].host_read() + i * n, n, buf + m);
    m += (int) n;
  }
  return m;
}

int ParticleFields::unpack(int i, const double *buf)
{
  int m = 0;
  for (int id = 0; id < TM_F_COUNT; id++) {
    if (!(used & (1u << id))) continue;
    const size_t n = tm_field_table[id].columns;
    std::copy_n(buf + m, n, values[id].host_write() + i * n);
    m += (int) n;
  }
  return m;
}

double ParticleFields::bytes() const { return (double) rows * width * sizeof(double); }

}    // namespace SPHTM_NS
