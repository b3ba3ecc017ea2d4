#include "server/commands/model_sources.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string_view>

#include "core/input/errors.h"
#include "server/commands/files.h"

namespace tia::server {
namespace {

namespace fs = std::filesystem;

struct OwnedFile {
  std::string path, bytes;
};

bool has_ending(const fs::path& path, std::string_view ending) {
  std::string own = path.extension().string();
  for (char& each : own)
    if (each >= 'A' && each <= 'Z') each = static_cast<char>(each - 'A' + 'a');
  return own == ending;
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

// An OBJ may do without its materials, and so would not ask for them.
void add_materials(const fs::path& main, std::vector<OwnedFile>& files) {
  if (!has_ending(main, ".obj")) return;
  for (const auto& entry : fs::directory_iterator(folder_of(main)))
    if (entry.is_regular_file() && has_ending(entry.path(), ".mtl"))
      files.push_back({entry.path().filename().generic_string(), read_file(entry.path().string())});
}

// Adds what the faults miss and stands in the folder of the model's file or below it, each file
// once. Returns: whether there was any.
bool add_missing(const std::vector<Fault>& faults, const fs::path& main,
                 std::vector<OwnedFile>& files) {
  bool any = false;
  for (const Fault& fault : faults) {
    const auto* name = fault.got ? fault.got->as<std::string>() : nullptr;
    if (fault.kind != FaultKind::missing || name == nullptr) continue;
    const fs::path path = fs::path(*name).lexically_normal();
    const bool within = path.is_relative() && *path.begin() != "..";
    const bool had = std::ranges::count(files, path.generic_string(), &OwnedFile::path) > 0;
    if (!within || had || !fs::is_regular_file(folder_of(main) / path)) continue;
    files.push_back({path.generic_string(), read_file((folder_of(main) / path).string())});
    any = true;
  }
  return any;
}

ModelFiles seen(const std::vector<OwnedFile>& owned) {
  ModelFiles files;
  for (const OwnedFile& each : owned)
    files.all.push_back(
        {each.path, {reinterpret_cast<const std::uint8_t*>(each.bytes.data()), each.bytes.size()}});
  return files;
}

}  // namespace

void read_model_files(const std::vector<std::string>& names,
                      const std::function<void(const ModelFiles&)>& read) {
  const fs::path main = names.front();
  std::vector<OwnedFile> files;
  for (const std::string& name : names)
    files.push_back({fs::path(name).filename().generic_string(), read_file(name)});
  if (names.size() == 1) add_materials(main, files);
  for (;;) {
    try {
      return read(seen(files));
    } catch (const InputError& error) {
      if (!add_missing(error.faults(), main, files))
        throw std::runtime_error(names.front() + ": " + error.what());
    }
  }
}

}  // namespace tia::server
