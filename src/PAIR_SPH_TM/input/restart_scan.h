/* SPH-TM: a restart file looked through as a whole, before LAMMPS believes what it says.

   LAMMPS writes header, groups and masses, then the pair style, the fixes, and a row of numbers for each particle. The
   pair style keeps a checksum of what stands before it, fix sph/tm one of all rows (x, v, type, tag and what the fixes
   keep). Both are held against the file while the pair style is read; lengths are followed only within the file. */
#ifndef SPHTM_RESTART_SCAN_H
#define SPHTM_RESTART_SCAN_H

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHTM_NS {

// name of an open file, or ""
std::string file_name(FILE *);

// the bytes of the file before its position; hash 0: not known
struct FrontHash {
  uint64_t bytes = 0, hash = 0;
};
FrontHash front_hash(FILE *, const std::string &name);

// all rows of particles as LAMMPS writes them; hash: a sum, the same in any order. Collective
struct RowsHash {
  uint64_t rows = 0, hash = 0;
};
RowsHash rows_hash(LAMMPS_NS::LAMMPS *);
// as the first numbers of the block of fix sph/tm
constexpr int ROWS_HASH_VALUES = 4;
void append_rows_hash(std::vector<double> &, const RowsHash &);

// From the end of the pair style to the end of the file; the position is left where it was. "" or what is wrong.
// pattern: of a file in parts its name with %, or ""; fix_names: as it was written, 0: not known
std::string scan_restart(FILE *, const std::string &pattern, uint64_t fix_names);
uint64_t fix_names_hash(LAMMPS_NS::LAMMPS *);

}    // namespace SPHTM_NS

#endif
