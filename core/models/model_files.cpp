#include "core/models/model_files.h"

#include <algorithm>
#include <optional>

namespace tia {
namespace {

// A path below a folder with `.` and `..` resolved; none where it begins with '/' or leads out.
std::optional<std::string> resolved(std::string_view folder, std::string_view path) {
  if (path.starts_with('/')) return std::nullopt;
  std::string all;
  for (std::string_view rest : {folder, path}) {
    while (!rest.empty()) {
      const std::string_view part = rest.substr(0, rest.find('/'));
      rest.remove_prefix(std::min(rest.size(), part.size() + 1));
      if (part.empty() || part == ".") continue;
      if (part == "..") {
        if (all.empty()) return std::nullopt;
        const std::size_t slash = all.rfind('/');
        all.resize(slash == all.npos ? 0 : slash);
        continue;
      }
      if (!all.empty()) all += '/';
      all += part;
    }
  }
  return all;
}

}  // namespace

const ModelFile* ModelFiles::find(std::string_view path, std::string_view from) const {
  const std::size_t slash = from.rfind('/');
  const std::string_view folder = slash == from.npos ? std::string_view() : from.substr(0, slash);
  const auto wanted = resolved(folder, path);
  if (!wanted) return nullptr;
  const auto found = std::ranges::find(all, *wanted, &ModelFile::path);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace tia
