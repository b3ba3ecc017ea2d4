// What a test and the program that it breaks both see: which call of the C library fails, when and
// how. It lies in a file that both have mapped, so that faults begin and end while the program
// runs. In C and in C++.
#pragma once

// clang-format off
// The calls that can be broken, by the C library's names for them.
#define FAULTS_CALLS(X)                                                                      \
  X(accept) X(bind) X(close) X(epoll_create1) X(epoll_ctl) X(epoll_wait) X(eventfd) X(fcntl) \
  X(fdatasync) X(fopen) X(fstat) X(fsync) X(ftruncate) X(getpeername) X(ioctl) X(linkat)     \
  X(listen) X(madvise) X(malloc) X(mmap) X(open) X(openat) X(pipe) X(poll) X(pread)          \
  X(pthread_create) X(pwrite) X(read) X(recv) X(send) X(setsockopt) X(shutdown) X(socket)    \
  X(timerfd_create) X(timerfd_settime) X(unlink) X(write) X(writev)
// clang-format on

enum faults_call {
#define FAULTS_ENUMERATOR(name) faults_##name,
  FAULTS_CALLS(FAULTS_ENUMERATOR)
#undef FAULTS_ENUMERATOR
};

// One call fails, from its first-th time on to the last-th, each every-th time. Both sides reach
// the numbers by atomic operations.
struct faults {
  int call;                 // -1 = none
  int error;                // errno; 0 = it moves one byte where it may move more
  long first, last, every;  // times, counted from when `call` is set
  long came, failed;        // how often it has come since, and of those failed
  char folder[256];         // of files only those below it; "" = all
};

// The environment's variable that names the file.
#define FAULTS_FILE "FAULTS_FILE"
