// Blobs in a folder that all machines of a farm see: a file each, written under another name and
// renamed once it is on the disk (rename(2) replaces at once, also by NFS).
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "server/contract/problem.h"
#include "server/stores/blobs.h"
#include "server/stores/random_key.h"
#include "server/stores/unnamed_file.h"

namespace tia::server {
namespace {

[[noreturn]] void refuse_blob(int error, const char* call) {
  if (error == ENOSPC || error == EDQUOT) throw store_full();
  throw StorageAway(std::string("the folder of TIA_STORE: ") + call + ": " +
                    std::strerror(error));  // NOLINT(concurrency-mt-unsafe): glibc's is safe
}

void sync_folder(const std::filesystem::path& path) {
  const OpenFile folder(open(path.c_str(), O_DIRECTORY | O_CLOEXEC));
  if (folder < 0 || fsync(folder) != 0) refuse_blob(errno, "fsync");
}

// It and those above it, on the disk.
void make_folder(const std::filesystem::path& path) {
  if (mkdir(path.c_str(), 0777) == 0) return sync_folder(path.parent_path());
  if (errno == EEXIST) return;
  if (errno != ENOENT) refuse_blob(errno, "mkdir");
  make_folder(path.parent_path());
  if (mkdir(path.c_str(), 0777) != 0 && errno != EEXIST) refuse_blob(errno, "mkdir");
  sync_folder(path.parent_path());
}

void write_blob(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t put = write(file, bytes.data(), bytes.size());
    if (put < 0 && errno != EINTR) refuse_blob(errno, "write");
    if (put > 0) bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  if (fsync(file) != 0) refuse_blob(errno, "fsync");
}

class FolderBlobs : public Blobs {
 public:
  explicit FolderBlobs(std::filesystem::path root) : root_(std::move(root)) {}

  void put(const std::string& name, std::string_view bytes) override {
    const std::filesystem::path path = root_ / name;
    make_folder(path.parent_path());
    const std::string unfinished = path.string() + ".part-" + random_key();
    try {
      const OpenFile file(open(unfinished.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
      if (file < 0) refuse_blob(errno, "open");
      write_blob(file, bytes);
      if (rename(unfinished.c_str(), path.c_str()) != 0) refuse_blob(errno, "rename");
    } catch (...) {
      unlink(unfinished.c_str());
      throw;
    }
    sync_folder(path.parent_path());
  }

  std::optional<std::string> find(const std::string& name) override {
    const OpenFile file(open((root_ / name).c_str(), O_RDONLY | O_CLOEXEC));
    if (file < 0 && errno == ENOENT) return std::nullopt;
    struct stat about {};
    if (file < 0 || fstat(file, &about) != 0) refuse_blob(errno, "open");
    std::string bytes(static_cast<std::size_t>(about.st_size), '\0');
    std::size_t have = 0;
    while (have < bytes.size()) {
      const ssize_t got = read(file, bytes.data() + have, bytes.size() - have);
      if (got < 0 && errno != EINTR) refuse_blob(errno, "read");
      if (got == 0) break;  // it has been cut: its hash will tell
      if (got > 0) have += static_cast<std::size_t>(got);
    }
    bytes.resize(have);
    return bytes;
  }

  // A folder goes with the last one that is in it.
  void remove(const std::string& name) override {
    const std::filesystem::path path = root_ / name;
    if (unlink(path.c_str()) != 0 && errno != ENOENT) refuse_blob(errno, "unlink");
    for (auto above = path.parent_path(); above != root_ && rmdir(above.c_str()) == 0;)
      above = above.parent_path();
  }

  std::vector<std::string> names(const std::string& prefix) override {
    std::vector<std::string> found;
    std::error_code error;
    for (std::filesystem::directory_iterator each(root_ / prefix, error), end;
         !error && each != end; each.increment(error))
      found.push_back(prefix + each->path().filename().string());
    if (error && error != std::errc::no_such_file_or_directory)
      refuse_blob(error.value(), "readdir");
    return found;
  }

 private:
  const std::filesystem::path root_;
};

}  // namespace

std::unique_ptr<Blobs> blobs_in_folder(const std::string& path) {
  struct stat about {};
  const bool is_folder = path.starts_with('/') && stat(path.c_str(), &about) == 0 &&
                         S_ISDIR(about.st_mode) && access(path.c_str(), W_OK) == 0;
  if (!is_folder)
    throw std::invalid_argument("got dir:" + path +
                                ", allowed: a folder that is there and can be written to, by its "
                                "whole path");
  std::string root = std::filesystem::path(path).lexically_normal();
  if (root.size() > 1 && root.ends_with('/')) root.pop_back();
  return std::make_unique<FolderBlobs>(root);
}

}  // namespace tia::server
