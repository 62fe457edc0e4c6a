#include "restart_block.h"

#include "pair_sph_tm.h"

#include "comm.h"
#include "error.h"
#include "force.h"
#include "lammps.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

namespace {
struct Head {
  uint64_t magic, values, hash;
};
constexpr uint64_t MAGIC = 0x314d545f48505321u;
}    // namespace

uint64_t hash_bytes(const void *data, size_t bytes, uint64_t seed)
{
  const auto *p = (const unsigned char *) data;
  uint64_t h = seed;
  for (size_t k = 0; k < bytes; k += 8) {
    uint64_t word = 0;
    memcpy(&word, p + k, bytes - k < 8 ? bytes - k : 8);
    h = (h ^ word) * 1099511628211u;
    h ^= h >> 32;
  }
  return h;
}

std::string restart_file_name(LAMMPS *lmp)
{
  const auto *pair = dynamic_cast<PairSPHTM *>(lmp->force->pair_match("^sph/tm", 0));
  const std::string name = pair ? pair->restart_file() : "";
  return name.empty() ? "restart file" : "restart file " + name;
}

void write_restart_block(FILE *fp, const std::vector<double> &values)
{
  const size_t bytes = values.size() * sizeof(double);
  const Head head = {MAGIC, values.size(), hash_bytes(values.data(), bytes)};
  const int size = (int) (sizeof(Head) + bytes);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(&head, sizeof(Head), 1, fp);
  fwrite(values.data(), 1, bytes, fp);
}

std::vector<double> read_restart_block(LAMMPS *lmp, const std::string &who, const char *buf, size_t least, size_t most)
{
  Error *error = lmp->error;
  Head head;
  memcpy(&head, buf, sizeof(Head));
  const std::string name = restart_file_name(lmp);
  if (head.magic != MAGIC)
    error->all(FLERR, "{}: the {} is damaged, or was written by another version of the plugin", who, name);
  if (head.values < least || head.values > most)
    error->all(FLERR, "{}: the {} is damaged, or was written by another version of the plugin: {} values, {} expected",
               who, name, head.values,
               least == most ? std::to_string(least) : fmt::format("{} to {}", least, most));
  std::vector<double> values(head.values);
  memcpy(values.data(), buf + sizeof(Head), head.values * sizeof(double));
  if (hash_bytes(values.data(), head.values * sizeof(double)) != head.hash)
    error->all(FLERR, "{}: the {} is damaged: the checksum does not fit", who, name);
  for (const double v : values)
    if (!std::isfinite(v))
      error->all(FLERR, "{}: the {} was written after a fault: it holds a value that is not a finite number", who, name);
  return values;
}

void write_restart_sum(LAMMPS *lmp, double mine, FILE *fp)
{
  double all = 0.0;
  MPI_Reduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, 0, lmp->world);
  if (lmp->comm->me == 0) write_restart_block(fp, {all});
}

void read_restart_sum(LAMMPS *lmp, const std::string &who, double &mine, const char *buf)
{
  const double all = read_restart_block(lmp, who, buf, 1, 1)[0];
  if (lmp->comm->me == 0) mine = all;
}

void append_bits(std::vector<double> &values, uint64_t bits)
{
  values.push_back((double) (bits >> 32));
  values.push_back((double) (bits & 0xffffffffu));
}

uint64_t take_bits(const double *two) { return (uint64_t) two[0] << 32 | (uint64_t) two[1]; }

}    // namespace SPHTM_NS
