#include "server/stores/model_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "server/contract/problem.h"
#include "server/stores/model_upload.h"

namespace tia::server {

std::string SentFile::contents() {
  std::string bytes = file_.contents();
  sha256_ = hash_.digits();
  if (sha256_hex(bytes) != sha256_)
    throw StorageError("the folder of kept models gives back other bytes than it was given");
  return bytes;
}

ModelFolder::ModelFolder(const std::string& data_dir, std::int64_t max_bytes)
    : path_(data_dir + "/models"), room_(max_bytes) {
  const int made = mkdir(path_.c_str(), 0777);  // less what the process' mask takes
  if (made == 0 || errno == EEXIST)
    folder_ = OpenFile(open(path_.c_str(), O_DIRECTORY | O_CLOEXEC));
  if (folder_ < 0 || access(path_.c_str(), W_OK) != 0)
    throw std::runtime_error("option TIA_DATA_DIR: " + path_ + ": " + std::strerror(errno));
  measure();
}

void ModelFolder::measure() {
  for (const auto& entry : std::filesystem::directory_iterator(path_)) {
    if (!is_model_id(entry.path().filename().string())) continue;
    ++count_;
    room_.count(static_cast<std::int64_t>(entry.file_size()));
  }
}

bool ModelFolder::contains(const std::string& id) const {
  return faccessat(folder_, id.c_str(), F_OK, 0) == 0;
}

void ModelFolder::keep(const std::string& id, const std::vector<std::string_view>& pieces) {
  if (contains(id)) return;
  UnnamedFile file(folder_, room_);
  for (const std::string_view piece : pieces) file.append(piece);
  keep(id, file);
}

// Somebody may have kept the same meanwhile.
void ModelFolder::keep(const std::string& id, UnnamedFile& file) {
  if (!contains(id) && file.publish(id)) ++count_;
}

std::optional<std::string> ModelFolder::find(const std::string& id) const {
  const OpenFile file(openat(folder_, id.c_str(), O_RDONLY | O_CLOEXEC));
  if (file < 0 && errno == ENOENT) return std::nullopt;
  if (file < 0) refuse_file(errno, "open");
  return read_file(file, static_cast<std::size_t>(size_of(file)));
}

void ModelFolder::remove(const std::string& id) {
  const OpenFile file(openat(folder_, id.c_str(), O_RDONLY | O_CLOEXEC));
  const std::int64_t bytes = file < 0 ? 0 : size_of(file);
  if (unlinkat(folder_, id.c_str(), 0) != 0) {
    if (errno != ENOENT) refuse_file(errno, "unlink");
    return;
  }
  --count_;
  room_.count(-bytes);
}

}  // namespace tia::server
