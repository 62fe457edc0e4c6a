/* SPH-TM: what a style writes into a restart file, with its length and a checksum.

   LAMMPS hands a fix its bytes without saying how many there are, so a block says it itself; it is believed only
   between the least and the most numbers that the style can have written. */
#ifndef SPHTM_RESTART_BLOCK_H
#define SPHTM_RESTART_BLOCK_H

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHTM_NS {

// of bytes (FNV-1a by words of 8), chained through seed
constexpr uint64_t HASH_SEED = 1469598103934665603u;
uint64_t hash_bytes(const void *data, size_t bytes, uint64_t seed = HASH_SEED);

// what a block begins with
struct BlockHead {
  uint64_t magic, bytes, hash;
  static constexpr uint64_t MAGIC = 0x324d545f48505321u;
  BlockHead() = default;
  BlockHead(const void *data, size_t n) : magic(MAGIC), bytes(n), hash(hash_bytes(data, n)) {}
};

// the restart file in use, for messages: "restart file name", or "restart file" where its name is not known
std::string restart_file_name(LAMMPS_NS::LAMMPS *);

// Bytes of the pair style, on the first rank, and back on every rank: `bytes` of them, or an error that names the file
void write_checked(FILE *, const void *data, size_t bytes);
void read_checked(LAMMPS_NS::LAMMPS *, const std::string &who, FILE *, void *data, size_t bytes);

// Global state of a fix: on the first rank, from Fix::write_restart
void write_restart_block(FILE *, const std::vector<double> &values);
// and back, on every rank, from Fix::restart. An error that names the file and `who` where the block is damaged, has
// less than `least` or more than `most` values, or one that is not a finite number
std::vector<double> read_restart_block(LAMMPS_NS::LAMMPS *, const std::string &who, const char *buf, size_t least,
                                       size_t most);

// A number of a fix, the sum over the ranks (collective), which the first rank takes up again
void write_restart_sum(LAMMPS_NS::LAMMPS *, double mine, FILE *);
void read_restart_sum(LAMMPS_NS::LAMMPS *, const std::string &who, double &mine, const char *buf);

// 64 bits as two finite numbers and back
void append_bits(std::vector<double> &, uint64_t bits);
uint64_t take_bits(const double *two);

}    // namespace SPHTM_NS

#endif
