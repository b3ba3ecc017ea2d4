// Source: open(2), O_TMPFILE.
#include "server/stores/unnamed_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "server/contract/problem.h"

namespace tia::server {
namespace {

void write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t put = write(file, bytes.data(), bytes.size());
    if (put < 0 && errno != EINTR) refuse_file(errno, "write");
    if (put > 0) bytes.remove_prefix(static_cast<std::size_t>(put));
  }
}

}  // namespace

OpenFile::~OpenFile() {
  if (number_ >= 0) close(number_);
}

// What the system says goes to the log only; clients get the problem.
void refuse_file(int error, const char* call) {
  if (error == ENOSPC || error == EDQUOT)
    throw HttpError("storage-full", "the disk of kept models is full");
  throw StorageError(std::string("the folder of kept models: ") + call + ": " +
                     std::strerror(error));  // NOLINT(concurrency-mt-unsafe): glibc's is safe
}

std::int64_t size_of(const OpenFile& file) {
  struct stat about {};
  if (fstat(file, &about) != 0) refuse_file(errno, "fstat");
  return about.st_size;
}

std::string read_file(const OpenFile& file, std::size_t bytes) {
  std::string read(bytes, '\0');
  std::size_t have = 0;
  while (have < bytes) {
    const ssize_t got = pread(file, read.data() + have, bytes - have, static_cast<off_t>(have));
    if (got < 0 && errno != EINTR) refuse_file(errno, "read");
    if (got == 0) break;  // it has been cut: its hash will tell
    if (got > 0) have += static_cast<std::size_t>(got);
  }
  read.resize(have);
  return read;
}

void DiskRoom::take(std::int64_t bytes) {
  if ((used_ += bytes) <= most_) return;
  used_ -= bytes;
  throw HttpError("storage-full", "kept models have " + std::to_string(most_) +
                                      " bytes in all (option TIA_MAX_DATA_BYTES)");
}

void UnnamedFile::append(std::string_view bytes) {
  if (file_ < 0) open();
  room_.take(static_cast<std::int64_t>(bytes.size()));
  unnamed_ += static_cast<std::int64_t>(bytes.size());
  write_all(file_, bytes);
  size_ += bytes.size();
}

void UnnamedFile::open() {
  file_ = OpenFile(openat(folder_, ".", O_TMPFILE | O_RDWR | O_CLOEXEC, 0666));
  if (file_ < 0) refuse_file(errno, "open");
}

std::string UnnamedFile::contents() const { return read_file(file_, size_); }

bool UnnamedFile::publish(const std::string& name) {
  if (file_ < 0) open();
  if (fsync(file_) != 0) refuse_file(errno, "fsync");
  const std::string unnamed = "/proc/self/fd/" + std::to_string(file_);
  if (linkat(AT_FDCWD, unnamed.c_str(), folder_, name.c_str(), AT_SYMLINK_FOLLOW) != 0) {
    if (errno == EEXIST) return false;
    refuse_file(errno, "linkat");
  }
  unnamed_ = 0;
  if (fsync(folder_) != 0) refuse_file(errno, "fsync");
  return true;
}

}  // namespace tia::server
