#include "tool_file.h"

#include "tm_mesh_read.h"

#include "fmt/format.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace SPHTM_NS {

std::string first_message(MPI_Comm world, const std::string &mine)
{
  int me, ranks, first;
  MPI_Comm_rank(world, &me);
  MPI_Comm_size(world, &ranks);
  const int says = mine.empty() ? ranks : me;
  MPI_Allreduce(&says, &first, 1, MPI_INT, MPI_MIN, world);
  if (first == ranks) return "";
  int length = (int) mine.size();
  MPI_Bcast(&length, 1, MPI_INT, first, world);
  std::string message = mine;
  message.resize(length);
  MPI_Bcast(&message[0], length, MPI_CHAR, first, world);
  return message;
}

// what a file is that is not a regular one, or nullptr
static const char *irregular(const struct stat &s)
{
  if (S_ISREG(s.st_mode)) return nullptr;
  if (S_ISDIR(s.st_mode)) return "a directory";
  if (S_ISFIFO(s.st_mode)) return "a named pipe (FIFO)";
  if (S_ISSOCK(s.st_mode)) return "a socket";
  if (S_ISCHR(s.st_mode) || S_ISBLK(s.st_mode)) return "a device";
  return "no regular file";
}

static std::string unfit(const struct stat &s, size_t max_bytes)
{
  if (const char *what = irregular(s)) return fmt::format("it is {}; a tool is read from a regular file", what);
  if ((uint64_t) s.st_size <= max_bytes) return "";
  return fmt::format("it has {} bytes, more than the {} MB that are read; if it is the right file, raise that with "
                     "the keyword 'maxsize' (MB)",
                     s.st_size, max_bytes / 1000000);
}

// looked at before it is opened, which alone may block or act on a device, and again once it is open
std::string ToolFile::read_here(const std::string &name, size_t max_bytes)
{
  struct stat s;
  if (stat(name.c_str(), &s)) return fmt::format("cannot open the file: {}", strerror(errno));
  std::string wrong = unfit(s, max_bytes);
  if (!wrong.empty()) return wrong;
  const int fd = open(name.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (fd < 0) return fmt::format("cannot open the file: {}", strerror(errno));
  FILE *file = nullptr;
  if (fstat(fd, &s) || !(file = fdopen(fd, "rb"))) {
    wrong = fmt::format("cannot open the file: {}", strerror(errno));
    close(fd);
    return wrong;
  }
  char msg[256] = "";
  wrong = unfit(s, max_bytes);
  if (wrong.empty()) {
    unsigned char *data;
    tm_mesh_read_bytes(file, max_bytes, &data, &count, msg, sizeof msg);
    bytes.reset(data);
    wrong = msg;
  }
  fclose(file);
  if (wrong.empty() && count != (uint64_t) s.st_size)
    wrong = fmt::format("{} bytes were read, but its size is {} bytes; is it still being written?", count, s.st_size);
  return wrong;
}

std::string ToolFile::read(MPI_Comm world, const std::string &name, size_t max_bytes)
{
  int me;
  MPI_Comm_rank(world, &me);
  std::string wrong = me == 0 ? read_here(name, max_bytes) : "";
  if (!wrong.empty()) wrong = fmt::format("mesh file {}: {}", name, wrong);
  wrong = first_message(world, wrong);
  if (!wrong.empty()) return wrong;
  uint64_t size = count;
  MPI_Bcast(&size, 1, MPI_UINT64_T, 0, world);
  count = size;
  if (me) bytes.reset((unsigned char *) malloc(std::max(count, (size_t) 1)));
  wrong =
      first_message(world,
                    bytes ? "" : fmt::format("mesh file {}: no memory for its {} bytes on rank {}", name, count, me));
  if (!wrong.empty()) return wrong;
  constexpr size_t CHUNK = 1 << 28;
  for (size_t at = 0; at < count; at += CHUNK)
    MPI_Bcast(bytes.get() + at, (int) std::min(CHUNK, count - at), MPI_BYTE, 0, world);
  return "";
}

}    // namespace SPHTM_NS
