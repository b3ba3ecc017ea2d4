#include "core/models/model_files.h"

#include <algorithm>
#include <optional>

namespace tia {
namespace {

// A path's parts with `.` and `..` resolved; none where it begins with '/' or leads out.
std::optional<std::vector<std::string_view>> parts_of(std::string_view folder,
                                                      std::string_view path) {
  if (path.starts_with('/')) return std::nullopt;
  std::vector<std::string_view> parts;
  for (std::string_view rest : {folder, path}) {
    while (!rest.empty()) {
      const std::string_view part = rest.substr(0, rest.find('/'));
      rest.remove_prefix(std::min(rest.size(), part.size() + 1));
      if (part.empty() || part == ".") continue;
      if (part != "..") {
        parts.push_back(part);
        continue;
      }
      if (parts.empty()) return std::nullopt;
      parts.pop_back();
    }
  }
  return parts;
}

}  // namespace

const ModelFile* ModelFiles::find(std::string_view path, std::string_view from) const {
  const std::size_t slash = from.rfind('/');
  const std::string_view folder = slash == from.npos ? std::string_view() : from.substr(0, slash);
  const auto wanted = parts_of(folder, path);
  if (!wanted) return nullptr;
  const auto found = std::ranges::find_if(
      all, [&](const ModelFile& file) { return parts_of({}, file.path) == wanted; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace tia
