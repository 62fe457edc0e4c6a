#include "restart_scan.h"

#include "restart_block.h"

#include "atom.h"
#include "atom_vec.h"
#include "fix.h"
#include "fmt/format.h"
#include "lammps.h"
#include "lmprestart.h"
#include "modify.h"
#include "platform.h"
#include "utils.h"

#include <cstring>
#include <mpi.h>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

std::string file_name(FILE *fp)
{
  char path[4096];
  const char *name = platform::guesspath(fp, path, sizeof(path));
  return !name || strcmp(name, "(unknown)") == 0 ? "" : name;
}

FrontHash front_hash(FILE *fp, const std::string &name)
{
  FrontHash front;
  const auto end = (long) ftell(fp);
  if (end < 0 || name.empty()) return front;
  fflush(fp);
  FILE *again = fopen(name.c_str(), "rb");
  if (!again) return front;
  std::vector<char> data(end);
  front.bytes = fread(data.data(), 1, end, again);
  front.hash = front.bytes == (uint64_t) end ? hash_bytes(data.data(), end) : 0;
  fclose(again);
  return front;
}

RowsHash rows_hash(LAMMPS *lmp)
{
  const Atom *atom = lmp->atom;
  RowsHash mine, all;
  if (lmp->modify->restart_pbc_any) return mine;    // LAMMPS will move particles as it writes them
  std::vector<double> row(lmp->atom->avec->size_restart() + 1);
  for (int i = 0; i < atom->nlocal; i++) {
    const int n = lmp->atom->avec->pack_restart(i, row.data());
    mine.hash += hash_bytes(row.data(), n * sizeof(double));
    mine.rows++;
  }
  MPI_Allreduce(&mine, &all, 2, MPI_UINT64_T, MPI_SUM, lmp->world);
  return all;
}

void append_rows_hash(std::vector<double> &values, const RowsHash &h)
{
  append_bits(values, h.rows);
  append_bits(values, h.hash);
}

// of all fixes with a state in the file, in the order in which LAMMPS writes them: global states, then those of particles
uint64_t fix_names_hash(LAMMPS *lmp)
{
  std::string names;
  for (const bool of_particles : {false, true}) {
    for (const Fix *fix : lmp->modify->get_fix_list())
      if (of_particles ? fix->restart_peratom : fix->restart_global)
        names += std::string(fix->id) + "\n" + utils::strip_style_suffix(fix->style, lmp) + "\n";
    names += "\n";
  }
  return hash_bytes(names.data(), names.size());
}

namespace {

class Scan {
 public:
  Scan(FILE *f, const std::string &name, uint64_t hash) : fp(f), pattern(name), names_written(hash) {}
  std::string run();

 private:
  FILE *fp;
  const std::string pattern;
  const uint64_t names_written;
  std::string names;
  long left = 0;    // bytes
  RowsHash written, found;
  bool known = false;

  bool read(void *to, long bytes)
  {
    if (bytes < 0 || bytes > left || fread(to, 1, bytes, fp) != (size_t) bytes) return false;
    left -= bytes;
    return true;
  }
  bool read(int &n) { return read(&n, sizeof(int)); }
  bool read(std::string &text)    // with its length, which counts the 0 at the end
  {
    int n;
    if (!read(n) || n < 1 || n > 4096) return false;
    std::vector<char> bytes(n);
    if (!read(bytes.data(), n) || bytes.back() != 0 || strlen(bytes.data()) + 1 != (size_t) n) return false;
    text = bytes.data();
    return true;
  }
  std::string fixes();
  std::string fix_state(const std::string &id, const std::string &style);
  std::string rows();
  std::string part(int k);
  std::string chunks();
  bool row_chunk();
};

const char *const CUT = "it ends, or a length in it is wrong, among the values of fixes";

// of our own styles the checksum too
std::string Scan::fix_state(const std::string &id, const std::string &style)
{
  int n;
  if (!read(n) || n < 0 || n > left) return CUT;
  std::vector<char> state(n);
  if (!read(state.data(), n)) return CUT;
  const bool ours = style == "sph/tm" || style == "adapt/neigh" || style == "contact/tri" || style == "sph/tm/heat" ||
                    style == "sph/tm/drive" || style == "sph/tm/relax";
  if (!ours) return "";
  BlockHead head;
  if (n < (int) sizeof(head)) return fmt::format("values of fix {} are missing", id);
  memcpy(&head, state.data(), sizeof(head));
  const char *data = state.data() + sizeof(head);
  if (head.magic != BlockHead::MAGIC || head.bytes != n - sizeof(head) || hash_bytes(data, head.bytes) != head.hash)
    return fmt::format("the checksum of the values of fix {} does not fit", id);
  if (style != "sph/tm" || head.bytes < ROWS_HASH_VALUES * sizeof(double)) return "";
  double value[ROWS_HASH_VALUES];
  memcpy(value, data, sizeof(value));
  written.rows = take_bits(value);
  written.hash = take_bits(value + 2);
  known = true;
  return "";
}

std::string Scan::fixes()
{
  int count, size;
  std::string id, style;
  if (!read(count) || count < 0) return CUT;
  for (int k = 0; k < count; k++) {
    if (!read(id) || !read(style)) return CUT;
    names += id + "\n" + style + "\n";
    const std::string fault = fix_state(id, style);
    if (!fault.empty()) return fault;
  }
  names += "\n";
  if (!read(count) || count < 0) return CUT;
  for (int k = 0; k < count; k++)
    if (!read(id) || !read(style) || !read(size) || size < 0) return CUT;
    else names += id + "\n" + style + "\n";
  names += "\n";
  if (names_written && hash_bytes(names.data(), names.size()) != names_written)
    return "the names of fixes do not fit their checksum";
  return "";
}

bool Scan::row_chunk()
{
  int flag, n;
  if (!read(flag) || flag != PERPROC || !read(n) || n < 0 || n > left / (long) sizeof(double)) return false;
  std::vector<double> value(n);
  if (!read(value.data(), n * (long) sizeof(double))) return false;
  for (int m = 0; m < n;) {
    const double length = value[m];
    if (!(length >= 1.0 && length <= n - m) || length != (int) length) return false;
    found.hash += hash_bytes(&value[m], (size_t) length * sizeof(double));
    found.rows++;
    m += (int) length;
  }
  return true;
}

// to the end of the file
std::string Scan::chunks()
{
  const long end = sizeof(MAGIC_STRING);
  while (left > end)
    if (!row_chunk()) return "it ends, or a length in it is wrong, among the particles";
  char magic[sizeof(MAGIC_STRING)];
  if (!read(magic, end) || memcmp(magic, MAGIC_STRING, end) != 0) return "its end is missing";
  return "";
}

std::string Scan::part(int k)
{
  std::string name = pattern;
  name.replace(name.find('%'), 1, std::to_string(k));
  FILE *const base = fp;
  fp = fopen(name.c_str(), "rb");
  std::string fault;
  int flag, ranks;
  if (!fp) fault = fmt::format("its part {} cannot be opened", name);
  else {
    fseek(fp, 0, SEEK_END);
    left = ftell(fp);
    rewind(fp);
    if (!read(flag) || flag != PROCSPERFILE || !read(ranks)) fault = "it does not begin as a part";
    else fault = chunks();
    if (!fault.empty()) fault = fmt::format("part {}: {}", name, fault);
    fclose(fp);
  }
  fp = base;
  return fault;
}

std::string Scan::rows()
{
  int flag, parts = 0;
  if (!read(flag)) return CUT;
  if (flag != MULTIPROC || !read(parts) || !read(flag) || flag != -1)
    return "the layout of the file is not one of LAMMPS";
  if (parts && pattern.find('%') == std::string::npos) return "";    // a name that is not known
  std::string fault = parts ? "" : chunks();
  for (int k = 0; k < parts && fault.empty(); k++) fault = part(k);
  if (!fault.empty()) return fault;
  if (known && written.hash && (found.rows != written.rows || found.hash != written.hash))
    return found.rows != written.rows ? fmt::format("it holds {} of {} particles", found.rows, written.rows)
                                      : std::string("the checksum of the particles does not fit");
  return "";
}

std::string Scan::run()
{
  const long at = ftell(fp);
  if (at < 0 || fseek(fp, 0, SEEK_END)) return "";
  left = ftell(fp) - at;
  fseek(fp, at, SEEK_SET);
  int flag;
  if (!read(flag)) return "it ends after the pair style";
  if (flag >= 0) return "";    // other force styles: LAMMPS reads them
  std::string fault = fixes();
  if (fault.empty()) fault = rows();
  return fault;
}

}    // namespace

std::string scan_restart(FILE *fp, const std::string &pattern, uint64_t fix_names)
{
  const long at = ftell(fp);
  const std::string fault = Scan(fp, pattern, fix_names).run();
  fseek(fp, at, SEEK_SET);
  return fault;
}

}    // namespace SPHTM_NS
