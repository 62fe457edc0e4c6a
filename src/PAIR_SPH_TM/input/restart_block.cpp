#include "restart_block.h"

#include "scene.h"

#include "comm.h"
#include "error.h"
#include "force.h"
#include "lammps.h"
#include "utils.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

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
  const auto scene = Scene::of(lmp);
  const std::string name = scene->has_pair() ? scene->model().restart_file() : "";
  return name.empty() ? "restart file" : "restart file " + name;
}

void write_checked(FILE *fp, const void *data, size_t bytes)
{
  const BlockHead head(data, bytes);
  fwrite(&head, sizeof(head), 1, fp);
  fwrite(data, 1, bytes, fp);
}

// what is wrong with a block of which the head says so and so, or ""
static std::string block_fault(const BlockHead &head, size_t least, size_t most)
{
  if (head.magic != BlockHead::MAGIC) return "is damaged, or was written by another version of the plugin";
  if (head.bytes < least || head.bytes > most)
    return fmt::format("is damaged, or was written by another version of the plugin: {} bytes, {} expected", head.bytes,
                       least == most ? std::to_string(least) : fmt::format("{} to {}", least, most));
  return "";
}

void read_checked(LAMMPS *lmp, const std::string &who, FILE *fp, void *data, size_t bytes)
{
  int wrong = 0;
  BlockHead head;
  if (lmp->comm->me == 0) {
    utils::sfread(FLERR, &head, sizeof(head), 1, fp, nullptr, lmp->error);
    wrong = block_fault(head, bytes, bytes).empty() ? 0 : 1;
    if (!wrong) utils::sfread(FLERR, data, 1, bytes, fp, nullptr, lmp->error);
    if (!wrong && hash_bytes(data, bytes) != head.hash) wrong = 2;
  }
  MPI_Bcast(&wrong, 1, MPI_INT, 0, lmp->world);
  MPI_Bcast(&head, sizeof(head), MPI_BYTE, 0, lmp->world);
  if (wrong)
    lmp->error->all(FLERR, "{}: the {} {}", who, restart_file_name(lmp),
                    wrong == 1 ? block_fault(head, bytes, bytes) : "is damaged: the checksum does not fit");
  MPI_Bcast(data, (int) bytes, MPI_BYTE, 0, lmp->world);
}

void write_restart_block(FILE *fp, const std::vector<double> &values)
{
  const size_t bytes = values.size() * sizeof(double);
  const int size = (int) (sizeof(BlockHead) + bytes);
  fwrite(&size, sizeof(int), 1, fp);
  write_checked(fp, values.data(), bytes);
}

std::vector<double> read_restart_block(LAMMPS *lmp, const std::string &who, const char *buf, size_t least, size_t most)
{
  Error *error = lmp->error;
  BlockHead head;
  memcpy(&head, buf, sizeof(head));
  const std::string name = restart_file_name(lmp),
                    fault = block_fault(head, least * sizeof(double), most * sizeof(double));
  if (!fault.empty()) error->all(FLERR, "{}: the {} {}", who, name, fault);
  std::vector<double> values(head.bytes / sizeof(double));
  memcpy(values.data(), buf + sizeof(head), values.size() * sizeof(double));
  if (hash_bytes(values.data(), head.bytes) != head.hash)
    error->all(FLERR, "{}: the {} is damaged: the checksum does not fit", who, name);
  for (const double v : values)
    if (!std::isfinite(v))
      error->all(FLERR, "{}: the {} was written after a fault: it holds a value that is not a finite number", who,
                 name);
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
