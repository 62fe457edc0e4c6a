/* Messages from and to the memory of a GPU, for an MPI that knows only the host's:  LD_PRELOAD=libdevice_mpi.so

   LAMMPS with Kokkos keeps exchange, ghosts and their communication on the GPU when MPI takes pointers to device memory
   ('package kokkos gpu/aware on'). Without that it copies whole arrays of particles to the host in every step. This library
   stands between LAMMPS and MPI (MPI's profiling interface) and takes those pointers in MPI_Send, MPI_Irecv and MPI_Wait.

   A message is copied into a buffer kept for its receiver, and a header with the buffer's handle is sent. The receiver
   copies from GPU to GPU (CUDA's handles for other processes, over NVLink where there is one), then acknowledges: so the
   buffer is free again. Where the receiver cannot open the handle, the message goes through pinned memory of both hosts.
   Both sides of a message must use device memory, and a receive is as long as its message: as LAMMPS has it.

   SPHTM_DEVICE_MPI_HOST=1 sends all through the host; SPHTM_DEVICE_MPI_SAY=1 says at the end how many went which way.

   LIMITS: one thread calls MPI; MPI_Waitany and the like do not know these receives. */
#include <cuda_runtime_api.h>
#include <mpi.h>

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TAG_PAYLOAD = 23041, TAG_ACK = 23042 };
enum { UNKNOWN, YES, NO };

typedef struct {
  cudaIpcMemHandle_t handle;
  uint64_t version;            /* of the buffer: another one is another allocation; 0: no handle */
  uint64_t bytes;
  int through_host;
} header;

/* what is known of one process of one communicator */
typedef struct {
  MPI_Comm comm;
  int rank;
  /* messages to it */
  char *buffer, *pinned;
  size_t room, pinned_room;
  cudaIpcMemHandle_t handle;
  uint64_t version;
  int opens;                   /* can it open a handle? */
  int waiting;                 /* for the acknowledgement of the last message */
  int answer;
  MPI_Request ack, payload;
  /* messages from it */
  char *mapped, *pinned_in;
  uint64_t mapped_version;
  size_t pinned_in_room;
} peer;

typedef struct {
  MPI_Request request;         /* of the header; null: free */
  peer *from;
  char *to;
  size_t bytes;
  int tag;
  header head;
} receive;

enum { MAX_RECEIVES = 64 };
static peer **peers;
static int n_peers;
static receive receives[MAX_RECEIVES];
static int n_receives;         /* in use */
static cudaStream_t stream;
static long n_direct, n_through_host;

static void check(cudaError_t status, const char *what)
{
  if (status == cudaSuccess) return;
  fprintf(stderr, "device_mpi: %s: %s\n", what, cudaGetErrorString(status));
  MPI_Abort(MPI_COMM_WORLD, 1);
}

static int on_device(const void *p)
{
  struct cudaPointerAttributes a;
  if (!p) return 0;
  if (cudaPointerGetAttributes(&a, p) != cudaSuccess) {
    cudaGetLastError();
    return 0;
  }
  return a.type == cudaMemoryTypeDevice;
}

static peer *find_peer(MPI_Comm comm, int rank)
{
  int i;
  for (i = 0; i < n_peers; i++)
    if (peers[i]->comm == comm && peers[i]->rank == rank) return peers[i];
  peers = (peer **) realloc(peers, sizeof(peer *) * (size_t) (n_peers + 1));
  peers[n_peers] = (peer *) calloc(1, sizeof(peer));
  peers[n_peers]->comm = comm;
  peers[n_peers]->rank = rank;
  peers[n_peers]->ack = peers[n_peers]->payload = MPI_REQUEST_NULL;
  if (!stream) { /* it goes before loops that run meanwhile */
    int last, first;
    check(cudaDeviceGetStreamPriorityRange(&last, &first), "stream");
    check(cudaStreamCreateWithPriority(&stream, cudaStreamNonBlocking, first), "stream");
  }
  return peers[n_peers++];
}

static void copy(void *to, const void *from, size_t bytes)
{
  check(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDefault, stream), "copy");
  check(cudaStreamSynchronize(stream), "copy");
}

static void make_pinned(char **p, size_t *room, size_t bytes)
{
  if (*room >= bytes) return;
  if (*p) check(cudaFreeHost(*p), "pinned memory");
  *room = bytes + bytes / 4;
  check(cudaHostAlloc((void **) p, *room, cudaHostAllocDefault), "pinned memory");
}

/* the last message to p has arrived, and its buffers are free */
static void finish(peer *p)
{
  if (!p->waiting) return;
  PMPI_Wait(&p->payload, MPI_STATUS_IGNORE);
  PMPI_Wait(&p->ack, MPI_STATUS_IGNORE);
  p->waiting = 0;
  p->opens = p->answer;
}

static void make_buffer(peer *p, size_t bytes)
{
  if (p->room >= bytes) return;
  /* the receiver may still have the old one open: it is left to the end of the program */
  p->room = 2 * bytes;
  check(cudaMalloc((void **) &p->buffer, p->room), "buffer");
  p->version++;
  if (cudaIpcGetMemHandle(&p->handle, p->buffer) != cudaSuccess) {
    cudaGetLastError();
    p->opens = NO;
  }
}

static int send_from_device(const void *from, size_t bytes, int rank, int tag, MPI_Comm comm)
{
  peer *p = find_peer(comm, rank);
  header h;
  finish(p);
  if (p->opens == UNKNOWN && getenv("SPHTM_DEVICE_MPI_HOST")) p->opens = NO;
  make_buffer(p, bytes);
  memset(&h, 0, sizeof h);
  h.through_host = p->opens != YES;    /* the first message goes so, and asks */
  if (p->opens != NO) {
    h.handle = p->handle;
    h.version = p->version;
  }
  h.bytes = bytes;
  if (h.through_host) n_through_host++;
  else n_direct++;
  if (h.through_host) {
    make_pinned(&p->pinned, &p->pinned_room, bytes);
    copy(p->pinned, from, bytes);
  } else
    copy(p->buffer, from, bytes);
  p->waiting = 1;
  PMPI_Irecv(&p->answer, 1, MPI_INT, rank, TAG_ACK, comm, &p->ack);
  if (h.through_host)
    PMPI_Isend(p->pinned, (int) bytes, MPI_BYTE, rank, TAG_PAYLOAD, comm, &p->payload);
  return PMPI_Send(&h, sizeof h, MPI_BYTE, rank, tag, comm);
}

/* can the buffer of this header be read here? */
static int open_buffer(peer *p, const header *h)
{
  if (!h->version) return 0;
  if (p->mapped && p->mapped_version == h->version) return 1;
  if (p->mapped) check(cudaIpcCloseMemHandle(p->mapped), "handle");
  p->mapped = NULL;
  if (cudaIpcOpenMemHandle((void **) &p->mapped, h->handle, cudaIpcMemLazyEnablePeerAccess) != cudaSuccess) {
    cudaGetLastError();
    p->mapped = NULL;
    return 0;
  }
  p->mapped_version = h->version;
  return 1;
}

static void take(receive *r)
{
  peer *p = r->from;
  int opens;
  if (r->head.bytes > r->bytes) {
    fprintf(stderr, "device_mpi: a message of %llu bytes for room of %llu\n", (unsigned long long) r->head.bytes,
            (unsigned long long) r->bytes);
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  opens = open_buffer(p, &r->head) ? YES : NO;
  if (r->head.through_host) {
    make_pinned(&p->pinned_in, &p->pinned_in_room, r->head.bytes);
    PMPI_Recv(p->pinned_in, (int) r->head.bytes, MPI_BYTE, p->rank, TAG_PAYLOAD, p->comm, MPI_STATUS_IGNORE);
    copy(r->to, p->pinned_in, r->head.bytes);
  } else {
    if (opens != YES) check(cudaErrorMapBufferObjectFailed, "the sender's buffer");
    copy(r->to, p->mapped, r->head.bytes);
  }
  PMPI_Send(&opens, 1, MPI_INT, p->rank, TAG_ACK, p->comm);
}

int MPI_Send(const void *from, int count, MPI_Datatype type, int rank, int tag, MPI_Comm comm)
{
  int size;
  if (count <= 0 || !on_device(from)) return PMPI_Send(from, count, type, rank, tag, comm);
  PMPI_Type_size(type, &size);
  return send_from_device(from, (size_t) count * (size_t) size, rank, tag, comm);
}

int MPI_Irecv(void *to, int count, MPI_Datatype type, int rank, int tag, MPI_Comm comm, MPI_Request *request)
{
  int size, k = 0, status;
  receive *r;
  if (count <= 0 || !on_device(to)) return PMPI_Irecv(to, count, type, rank, tag, comm, request);
  while (k < MAX_RECEIVES && receives[k].from) k++;
  if (k == MAX_RECEIVES) {
    fprintf(stderr, "device_mpi: more than %d receives at a time\n", MAX_RECEIVES);
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  PMPI_Type_size(type, &size);
  r = receives + k;
  r->from = find_peer(comm, rank);
  r->to = (char *) to;
  r->bytes = (size_t) count * (size_t) size;
  r->tag = tag;
  n_receives++;
  status = PMPI_Irecv(&r->head, sizeof r->head, MPI_BYTE, rank, tag, comm, request);
  r->request = *request;
  return status;
}

int MPI_Wait(MPI_Request *request, MPI_Status *status)
{
  int k, result;
  if (n_receives && *request != MPI_REQUEST_NULL)
    for (k = 0; k < MAX_RECEIVES; k++) {
      receive *r = receives + k;
      if (!r->from || r->request != *request) continue;
      result = PMPI_Wait(request, status);
      take(r);
      r->from = NULL;
      n_receives--;
      return result;
    }
  return PMPI_Wait(request, status);
}

int MPI_Finalize(void)
{
  int i;
  for (i = 0; i < n_peers; i++) finish(peers[i]);
  if (getenv("SPHTM_DEVICE_MPI_SAY"))
    fprintf(stderr, "device_mpi: %ld messages from GPU to GPU, %ld through the host\n", n_direct, n_through_host);
  return PMPI_Finalize();
}
