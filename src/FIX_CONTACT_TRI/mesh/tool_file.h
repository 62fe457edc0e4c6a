/* SPH-TM: the file of a tool. The first rank alone reads it, so that all have the same bytes wherever they run. */
#ifndef SPHTM_TOOL_FILE_H
#define SPHTM_TOOL_FILE_H

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <mpi.h>
#include <string>

namespace SPHTM_NS {

// of the messages of the ranks the first that is not empty, on all of them (collective)
std::string first_message(MPI_Comm world, const std::string &mine);

class ToolFile {
 public:
  // empty, or what is wrong; the same on all ranks (collective). A file of more than max_bytes is not read
  std::string read(MPI_Comm world, const std::string &name, size_t max_bytes);
  const unsigned char *data() const { return bytes.get(); }
  size_t size() const { return count; }

 private:
  struct Free {
    void operator()(unsigned char *p) const { free(p); }
  };
  std::unique_ptr<unsigned char, Free> bytes;
  size_t count = 0;

  std::string read_here(const std::string &name, size_t max_bytes);
};

}    // namespace SPHTM_NS

#endif
