// Calls of the C library that fail when a test wants them to. Preloaded into a program (LD_PRELOAD)
// each stands before the library's own; the program need not know.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/timerfd.h>
#include <sys/uio.h>
#include <unistd.h>

#include "tests/faults/faults.h"

static struct faults* shared;

__attribute__((constructor)) static void map_shared(void) {
  const char* const path = getenv(FAULTS_FILE);
  if (path == NULL) return;
  const long file = syscall(SYS_openat, AT_FDCWD, path, O_RDWR | O_CLOEXEC);
  if (file < 0) return;
  const long at =
      syscall(SYS_mmap, NULL, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  syscall(SYS_close, file);
  if (at > 0) shared = (struct faults*)at;
}

// ---- whether a call fails -------------------------------------------------------------------

// Counts the call. Returns: whether it fails; then errno is set.
static int breaks(enum faults_call call) {
  if (shared == NULL || __atomic_load_n(&shared->call, __ATOMIC_ACQUIRE) != (int)call) return 0;
  const long n = __atomic_add_fetch(&shared->came, 1, __ATOMIC_RELAXED);
  if (n < shared->first || n > shared->last || (n - shared->first) % shared->every != 0) return 0;
  __atomic_add_fetch(&shared->failed, 1, __ATOMIC_RELAXED);
  errno = shared->error;
  return 1;
}

static int is_in_folder(const char* path) {
  const size_t size = strlen(shared->folder);
  return strncmp(path, shared->folder, size) == 0 && (path[size] == '/' || path[size] == '\0');
}

// Of a file by its path.
static int breaks_at(enum faults_call call, const char* path) {
  if (shared == NULL || (shared->folder[0] != '\0' && !is_in_folder(path))) return 0;
  return breaks(call);
}

// Of one that is open.
static int breaks_on(enum faults_call call, int file) {
  if (shared == NULL || shared->folder[0] == '\0') return breaks(call);
  char link[40], path[512];
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  const long size = syscall(SYS_readlinkat, AT_FDCWD, link, path, sizeof path - 1);
  path[size < 0 ? 0 : size] = '\0';
  return breaks_at(call, path);
}

// ---- calls ----------------------------------------------------------------------------------

// The library's own function of that name.
#define NEXT(name)               \
  static __typeof__(name)* next; \
  if (next == NULL) *(void**)(&next) = dlsym(RTLD_NEXT, #name)

#define CALL(type, name, broken, failure, parameters, arguments) \
  type name parameters {                                         \
    NEXT(name);                                                  \
    if (broken) return failure;                                  \
    return next arguments;                                       \
  }

CALL(int, accept, breaks(faults_accept), -1, (int s, struct sockaddr* a, socklen_t* n), (s, a, n))
CALL(int, bind, breaks(faults_bind), -1, (int s, const struct sockaddr* a, socklen_t n), (s, a, n))
CALL(int, close, breaks_on(faults_close, f) && (next(f), 1), -1, (int f), (f))
CALL(int, epoll_create1, breaks(faults_epoll_create1), -1, (int flags), (flags))
// To add one is what may fail, for want of memory or of watches.
CALL(int, epoll_ctl, o == EPOLL_CTL_ADD && breaks(faults_epoll_ctl), -1, (int p, int o, int f, struct epoll_event* e),
     (p, o, f, e))
CALL(int, epoll_wait, breaks(faults_epoll_wait), -1, (int p, struct epoll_event* e, int n, int ms),
     (p, e, n, ms))
CALL(int, eventfd, breaks(faults_eventfd), -1, (unsigned n, int flags), (n, flags))
CALL(int, fdatasync, breaks_on(faults_fdatasync, f), -1, (int f), (f))
CALL(int, fsync, breaks_on(faults_fsync, f), -1, (int f), (f))
CALL(int, getpeername, breaks(faults_getpeername), -1, (int s, struct sockaddr* a, socklen_t* n),
     (s, a, n))
CALL(int, linkat, breaks_on(faults_linkat, t), -1,
     (int f, const char* from, int t, const char* to, int flags), (f, from, t, to, flags))
CALL(int, listen, breaks(faults_listen), -1, (int s, int n), (s, n))
CALL(int, madvise, breaks(faults_madvise), -1, (void* p, size_t n, int how), (p, n, how))
CALL(int, pipe, breaks(faults_pipe), -1, (int ends[2]), (ends))
CALL(int, poll, breaks(faults_poll), -1, (struct pollfd * p, nfds_t n, int ms), (p, n, ms))
CALL(int, pthread_create, breaks(faults_pthread_create), errno,
     (pthread_t * t, const pthread_attr_t* a, void* (*f)(void*), void* p), (t, a, f, p))
CALL(int, setsockopt, breaks(faults_setsockopt), -1,
     (int s, int level, int o, const void* p, socklen_t n), (s, level, o, p, n))
CALL(int, shutdown, breaks(faults_shutdown), -1, (int s, int how), (s, how))
CALL(int, socket, breaks(faults_socket), -1, (int d, int t, int p), (d, t, p))
CALL(int, timerfd_create, breaks(faults_timerfd_create), -1, (clockid_t c, int flags), (c, flags))
CALL(int, timerfd_settime, breaks(faults_timerfd_settime), -1,
     (int f, int flags, const struct itimerspec* to, struct itimerspec* was), (f, flags, to, was))
CALL(int, unlink, breaks_at(faults_unlink, path), -1, (const char* path), (path))

// Files, which have names of their own where they may be large.
CALL(FILE*, fopen, breaks_at(faults_fopen, path), NULL, (const char* path, const char* mode),
     (path, mode))
CALL(FILE*, fopen64, breaks_at(faults_fopen, path), NULL, (const char* path, const char* mode),
     (path, mode))
CALL(int, fstat, breaks_on(faults_fstat, f), -1, (int f, struct stat* to), (f, to))
CALL(int, fstat64, breaks_on(faults_fstat, f), -1, (int f, struct stat64* to), (f, to))
CALL(int, ftruncate, breaks_on(faults_ftruncate, f), -1, (int f, off_t n), (f, n))
CALL(int, ftruncate64, breaks_on(faults_ftruncate, f), -1, (int f, off64_t n), (f, n))
CALL(void*, mmap, breaks_on(faults_mmap, f), MAP_FAILED,
     (void* p, size_t n, int prot, int flags, int f, off_t from), (p, n, prot, flags, f, from))
CALL(void*, mmap64, breaks_on(faults_mmap, f), MAP_FAILED,
     (void* p, size_t n, int prot, int flags, int f, off64_t from), (p, n, prot, flags, f, from))

// ---- calls whose last argument depends ------------------------------------------------------

#define LAST(type, after)                    \
  va_list arguments;                         \
  va_start(arguments, after);                \
  const type last = va_arg(arguments, type); \
  va_end(arguments)

int fcntl(int f, int how, ...) {
  NEXT(fcntl);
  LAST(long, how);
  return breaks_on(faults_fcntl, f) ? -1 : next(f, how, last);
}
int fcntl64(int f, int how, ...) {
  NEXT(fcntl64);
  LAST(long, how);
  return breaks_on(faults_fcntl, f) ? -1 : next(f, how, last);
}
int ioctl(int f, unsigned long how, ...) {
  NEXT(ioctl);
  LAST(long, how);
  return breaks_on(faults_ioctl, f) ? -1 : next(f, how, last);
}
int open(const char* path, int flags, ...) {
  NEXT(open);
  LAST(long, flags);
  return breaks_at(faults_open, path) ? -1 : next(path, flags, last);
}
int open64(const char* path, int flags, ...) {
  NEXT(open64);
  LAST(long, flags);
  return breaks_at(faults_open, path) ? -1 : next(path, flags, last);
}
// Of a folder that is open.
int openat(int f, const char* path, int flags, ...) {
  NEXT(openat);
  LAST(long, flags);
  return breaks_on(faults_openat, f) ? -1 : next(f, path, flags, last);
}
int openat64(int f, const char* path, int flags, ...) {
  NEXT(openat64);
  LAST(long, flags);
  return breaks_on(faults_openat, f) ? -1 : next(f, path, flags, last);
}

// ---- calls that move bytes ------------------------------------------------------------------

#define MOVE(name, call, parameters, arguments) \
  ssize_t name parameters {                     \
    NEXT(name);                                 \
    if (breaks_on(call, f)) {                   \
      if (errno != 0) return -1;                \
      if (n > 1) n = 1;                         \
    }                                           \
    return next arguments;                      \
  }

MOVE(read, faults_read, (int f, void* to, size_t n), (f, to, n))
MOVE(recv, faults_recv, (int f, void* to, size_t n, int flags), (f, to, n, flags))
MOVE(pread, faults_pread, (int f, void* to, size_t n, off_t at), (f, to, n, at))
MOVE(pread64, faults_pread, (int f, void* to, size_t n, off64_t at), (f, to, n, at))
MOVE(write, faults_write, (int f, const void* from, size_t n), (f, from, n))
MOVE(send, faults_send, (int f, const void* from, size_t n, int flags), (f, from, n, flags))
MOVE(pwrite, faults_pwrite, (int f, const void* from, size_t n, off_t at), (f, from, n, at))
MOVE(pwrite64, faults_pwrite, (int f, const void* from, size_t n, off64_t at), (f, from, n, at))

ssize_t writev(int f, const struct iovec* from, int parts) {
  NEXT(writev);
  if (!breaks_on(faults_writev, f)) return next(f, from, parts);
  if (errno != 0) return -1;
  return syscall(SYS_write, f, from->iov_base, from->iov_len > 1 ? 1 : from->iov_len);
}

ssize_t sendmsg(int f, const struct msghdr* all, int flags) {
  NEXT(sendmsg);
  if (!breaks_on(faults_send, f)) return next(f, all, flags);
  if (errno != 0) return -1;
  const struct iovec* first = all->msg_iov;
  return syscall(SYS_sendto, f, first->iov_base, first->iov_len > 1 ? 1 : first->iov_len, flags,
                 NULL, 0);
}

// ---- memory ---------------------------------------------------------------------------------

// Its own names, for to look for others' takes memory.
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);

void* malloc(size_t n) { return breaks(faults_malloc) ? NULL : __libc_malloc(n); }
void* calloc(size_t n, size_t of) { return breaks(faults_malloc) ? NULL : __libc_calloc(n, of); }
void* realloc(void* p, size_t n) { return breaks(faults_malloc) ? NULL : __libc_realloc(p, n); }
void* memalign(size_t unit, size_t n) {
  return breaks(faults_malloc) ? NULL : __libc_memalign(unit, n);
}
void* aligned_alloc(size_t unit, size_t n) { return memalign(unit, n); }
int posix_memalign(void** p, size_t unit, size_t n) {
  *p = memalign(unit, n);
  return *p == NULL ? ENOMEM : 0;
}
