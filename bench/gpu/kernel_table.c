/* SPH-TM bench: a Kokkos tool (KOKKOS_TOOLS_LIBS=libkernel_table.so) that counts and times kernels and counts copies
   between memories. At the end of the run it writes the file named by SPHTM_KERNEL_TABLE, a line each:
     kernel <tab> name <tab> launches <tab> seconds <tab> 0
     copy   <tab> to and from memory <tab> copies <tab> seconds <tab> bytes
     data   the same for copies of SPHTM_LARGE_COPY bytes or more: those of data of particles
     fill   the same for memory filled with one value, which Kokkos announces as a copy from nowhere
     memory <tab> memory: what for <tab> allocations <tab> 0 <tab> bytes at the time when that memory was fullest
     step   <tab> number of copies of data between two memories in a step <tab> steps <tab> 0 <tab> bytes in all of them
   A step goes from one launch of a kernel whose name begins with SPHTM_STEP_KERNEL to the next.
   Kokkos waits for the device around every launch while a tool is loaded: times are of the kernels alone. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { MAX_ROWS = 1024, MAX_NAME = 400 };

struct row {
  const char *kind;
  char name[MAX_NAME];
  uint64_t calls, bytes, held; /* held: bytes of memory now */
  double seconds;
};
static struct row rows[MAX_ROWS];
static int n_rows;
static double started;
static struct row *copying;
static uint64_t large = UINT64_MAX, copies_in_step, bytes_in_step;
static const char *step_kernel = "";

struct space {    /* Kokkos passes the name of a memory space by value */
  char name[64];
};

static double now(void)
{
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double) t.tv_sec + 1e-9 * (double) t.tv_nsec;
}

/* the row of a name, a new one at first sight; the last row takes what does not fit */
static struct row *find(const char *kind, const char *name)
{
  int i;
  for (i = 0; i < n_rows; i++)
    if (rows[i].kind == kind && !strncmp(rows[i].name, name, MAX_NAME - 1)) return &rows[i];
  if (n_rows == MAX_ROWS) return &rows[MAX_ROWS - 1];
  rows[n_rows].kind = kind;
  strncpy(rows[n_rows].name, name, MAX_NAME - 1);
  return &rows[n_rows++];
}

static const char kernel[] = "kernel", copy[] = "copy", data[] = "data", fill[] = "fill",
                  step[] = "step", memory[] = "memory";

static void end_step(void)
{
  char name[24];
  struct row *r;
  snprintf(name, sizeof name, "%llu", (unsigned long long) copies_in_step);
  r = find(step, name);
  r->calls++;
  r->bytes += bytes_in_step;
  copies_in_step = bytes_in_step = 0;
}

static void begin(const char *name, uint64_t *id)
{
  if (*step_kernel && !strncmp(name, step_kernel, strlen(step_kernel))) end_step();
  *id = (uint64_t) (find(kernel, name) - rows);
  started = now();
}

static void end(uint64_t id)
{
  rows[id].calls++;
  rows[id].seconds += now() - started;
}

void kokkosp_init_library(int sequence, uint64_t version, uint32_t devices, void *info)
{
  const char *bytes = getenv("SPHTM_LARGE_COPY"), *name = getenv("SPHTM_STEP_KERNEL");
  (void) sequence;
  (void) version;
  (void) devices;
  (void) info;
  if (bytes) large = strtoull(bytes, NULL, 10);
  if (name) step_kernel = name;
}

void kokkosp_begin_parallel_for(const char *name, uint32_t device, uint64_t *id)
{
  (void) device;
  begin(name, id);
}
void kokkosp_end_parallel_for(uint64_t id) { end(id); }
void kokkosp_begin_parallel_reduce(const char *name, uint32_t device, uint64_t *id)
{
  (void) device;
  begin(name, id);
}
void kokkosp_end_parallel_reduce(uint64_t id) { end(id); }
void kokkosp_begin_parallel_scan(const char *name, uint32_t device, uint64_t *id)
{
  (void) device;
  begin(name, id);
}
void kokkosp_end_parallel_scan(uint64_t id) { end(id); }

void kokkosp_begin_deep_copy(struct space to, const char *to_name, const void *to_ptr, struct space from,
                             const char *from_name, const void *from_ptr, uint64_t bytes)
{
  char name[MAX_NAME];
  (void) to_ptr;
  (void) from_ptr;
  snprintf(name, sizeof name, "%s <- %s: %.100s <- %.100s", to.name, from.name, to_name, from_name);
  copying = find(!strcmp(from_name, "(none)") ? fill : bytes >= large ? data : copy, name);
  copying->bytes += bytes;
  if (copying->kind == data && strcmp(to.name, from.name)) {
    copies_in_step++;
    bytes_in_step += bytes;
  }
  started = now();
}
void kokkosp_end_deep_copy(void)
{
  if (!copying) return;
  copying->calls++;
  copying->seconds += now() - started;
  copying = NULL;
}

/* Memory by name, of each space; `bytes` of its rows are those of its fullest time so far. */
static struct row *memory_of(struct space of, const char *name)
{
  char whole[MAX_NAME];
  snprintf(whole, sizeof whole, "%s: %.300s", of.name, name);
  return find(memory, whole);
}

void kokkosp_allocate_data(struct space of, const char *name, const void *p, uint64_t bytes)
{
  struct row *all = memory_of(of, "all"), *r = memory_of(of, name);
  const size_t length = strlen(of.name);
  int i;
  (void) p;
  r->calls++;
  r->held += bytes;
  all->calls++;
  all->held += bytes;
  if (all->held <= all->bytes) return;
  for (i = 0; i < n_rows; i++)
    if (rows[i].kind == memory && !strncmp(rows[i].name, of.name, length) && rows[i].name[length] == ':')
      rows[i].bytes = rows[i].held;
}
void kokkosp_deallocate_data(struct space of, const char *name, const void *p, uint64_t bytes)
{
  struct row *all = memory_of(of, "all"), *r = memory_of(of, name);
  (void) p;
  all->held -= bytes < all->held ? bytes : all->held; /* some memory was there before the tool, or had another name */
  r->held -= bytes < r->held ? bytes : r->held;
}

void kokkosp_finalize_library(void)
{
  const char *path = getenv("SPHTM_KERNEL_TABLE");
  FILE *f = path ? fopen(path, "w") : stderr;
  int i;
  if (!f) return;
  for (i = 0; i < n_rows; i++)
    fprintf(f, "%s\t%s\t%llu\t%.9g\t%llu\n", rows[i].kind, rows[i].name, (unsigned long long) rows[i].calls,
            rows[i].seconds, (unsigned long long) rows[i].bytes);
  if (path) fclose(f);
}
