// Source: open(2), O_TMPFILE, for files that are seen only once they are whole.
#include "server/stores/model_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "server/contract/problem.h"
#include "server/stores/model_upload.h"

namespace tia::server {
namespace {

// What the system says goes to the log only; clients get the problem.
[[noreturn]] void refuse_file(int error, const char* call) {
  if (error == ENOSPC || error == EDQUOT)
    throw HttpError("storage-full", "the disk of kept models is full");
  throw StorageError(std::string("the folder of kept models: ") + call + ": " +
                     std::strerror(error));  // NOLINT(concurrency-mt-unsafe): glibc's is safe
}

/// OpenFile: a descriptor, closed with its owner.
class OpenFile {
 public:
  explicit OpenFile(int number) : number_(number) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (number_ >= 0) close(number_);
  }
  operator int() const { return number_; }

 private:
  int number_;
};

void write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t put = write(file, bytes.data(), bytes.size());
    if (put < 0 && errno != EINTR) refuse_file(errno, "write");
    if (put > 0) bytes.remove_prefix(static_cast<std::size_t>(put));
  }
}

std::int64_t size_of(int file) {
  struct stat about {};
  if (fstat(file, &about) != 0) refuse_file(errno, "fstat");
  return about.st_size;
}

}  // namespace

ModelFolder::ModelFolder(const std::string& data_dir, std::int64_t max_bytes)
    : path_(data_dir + "/models"), max_bytes_(max_bytes) {
  const int made = mkdir(path_.c_str(), 0777);  // less what the process' mask takes
  if (made == 0 || errno == EEXIST) folder_ = open(path_.c_str(), O_DIRECTORY | O_CLOEXEC);
  if (folder_ < 0 || access(path_.c_str(), W_OK) != 0)
    throw std::runtime_error("option TIA_DATA_DIR: " + path_ + ": " + std::strerror(errno));
  measure();
}
ModelFolder::~ModelFolder() { close(folder_); }

void ModelFolder::measure() {
  for (const auto& entry : std::filesystem::directory_iterator(path_)) {
    if (!is_model_id(entry.path().filename().string())) continue;
    ++count_;
    bytes_ += static_cast<std::int64_t>(entry.file_size());
  }
}

bool ModelFolder::contains(const std::string& id) const {
  return faccessat(folder_, id.c_str(), F_OK, 0) == 0;
}

void ModelFolder::keep(const std::string& id, const std::vector<std::string_view>& pieces) {
  if (contains(id)) return;
  std::int64_t bytes = 0;
  for (const std::string_view piece : pieces) bytes += static_cast<std::int64_t>(piece.size());
  if (bytes_ + bytes > max_bytes_)
    throw HttpError("storage-full", "kept models have " + std::to_string(max_bytes_) +
                                        " bytes in all (option TIA_MAX_DATA_BYTES)");
  const OpenFile file(openat(folder_, ".", O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666));
  if (file < 0) refuse_file(errno, "open");
  for (const std::string_view piece : pieces) write_all(file, piece);
  if (fsync(file) != 0) refuse_file(errno, "fsync");
  const std::string unnamed = "/proc/self/fd/" + std::to_string(file);
  const int linked = linkat(AT_FDCWD, unnamed.c_str(), folder_, id.c_str(), AT_SYMLINK_FOLLOW);
  if (linked != 0 && errno == EEXIST) return;  // somebody has kept the same meanwhile
  if (linked != 0) refuse_file(errno, "linkat");
  if (fsync(folder_) != 0) refuse_file(errno, "fsync");
  ++count_;
  bytes_ += bytes;
}

std::optional<std::string> ModelFolder::find(const std::string& id) const {
  const OpenFile file(openat(folder_, id.c_str(), O_RDONLY | O_CLOEXEC));
  if (file < 0 && errno == ENOENT) return std::nullopt;
  if (file < 0) refuse_file(errno, "open");
  std::string bytes(static_cast<std::size_t>(size_of(file)), '\0');
  std::size_t have = 0;
  while (have < bytes.size()) {
    const ssize_t got = read(file, bytes.data() + have, bytes.size() - have);
    if (got < 0 && errno != EINTR) refuse_file(errno, "read");
    if (got == 0) break;  // it has been cut: its hash will tell
    if (got > 0) have += static_cast<std::size_t>(got);
  }
  bytes.resize(have);
  return bytes;
}

void ModelFolder::remove(const std::string& id) {
  const OpenFile file(openat(folder_, id.c_str(), O_RDONLY | O_CLOEXEC));
  const std::int64_t bytes = file < 0 ? 0 : size_of(file);
  if (unlinkat(folder_, id.c_str(), 0) != 0) {
    if (errno != ENOENT) refuse_file(errno, "unlink");
    return;
  }
  --count_;
  bytes_ -= bytes;
}

}  // namespace tia::server
