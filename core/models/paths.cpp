#include "core/models/paths.h"

#include <algorithm>
#include <utility>

#include "core/input/utf8.h"

namespace tia {
namespace {

bool is_drive_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// What a name's characters have to be and are not, or "".
std::string_view path_characters_wanted(std::string_view name) {
  while (!name.empty()) {
    const CodePoint point = decode_utf8(name);
    if (point.length == 0) return "a name in UTF-8";
    if (point.value < 0x20 || (point.value >= 0x7F && point.value < 0xA0))
      return "a name without control characters";
    name.remove_prefix(point.length);
  }
  return "";
}

// The part at a path's front, which is taken off it with the '/' behind.
std::string_view take_path_part(std::string_view& path) {
  const std::string_view part = path.substr(0, path.find('/'));
  path.remove_prefix(std::min(path.size(), part.size() + 1));
  return part;
}

// The parts, joined; nothing where one of them leads up.
std::optional<std::string> joined_path_parts(std::string_view path) {
  std::string joined;
  while (!path.empty()) {
    const std::string_view part = take_path_part(path);
    if (part == "..") return std::nullopt;
    if (part.empty() || part == ".") continue;
    if (!joined.empty()) joined += '/';
    joined += part;
  }
  return joined;
}

}  // namespace

std::optional<std::string> clean_path(std::string_view name, Faults& faults) {
  const auto refuse = [&](FaultKind kind, std::string allowed) {
    faults.add({kind, Place().at(name).pointer(), Value(name), std::move(allowed)});
    return std::nullopt;
  };
  if (name.size() > longest_path)
    return refuse(FaultKind::limit, "a path of at most " + std::to_string(longest_path) + " bytes");
  if (const std::string_view wanted = path_characters_wanted(name); !wanted.empty())
    return refuse(FaultKind::malformed, std::string(wanted));
  std::string path(name);
  std::replace(path.begin(), path.end(), '\\', '/');
  if (path.starts_with('/') || (path.size() > 1 && is_drive_letter(path[0]) && path[1] == ':'))
    return refuse(FaultKind::malformed, "a relative path, without a drive");
  auto joined = joined_path_parts(path);
  if (!joined) return refuse(FaultKind::malformed, "a path without \"..\"");
  if (joined->empty()) return refuse(FaultKind::malformed, "a path that names a file");
  return joined;
}

bool is_clutter(std::string_view path) {
  while (!path.empty()) {
    const std::string_view part = take_path_part(path);
    if (part == (path.empty() ? ".DS_Store" : "__MACOSX")) return true;
  }
  return false;
}

}  // namespace tia
