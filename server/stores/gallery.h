// The gallery: the scenes that come with the server, by name.
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "server/stores/known_scene.h"

namespace tia::server {

/// Gallery: every embedded /scenes/NAME.json. Each is read when it is first asked for, for a
/// program starts much more often than it needs all. Any thread may call. Errors: InputError for
/// one that is no scene.
class Gallery {
 public:
  Gallery();
  bool has(std::string_view name) const { return entries_.contains(name); }
  std::vector<std::string_view> names() const;
  /// The scene of that name, or null.
  KnownScene find(std::string_view name) const;
  /// All of them.
  std::map<std::string, KnownScene> scenes() const;
  /// The canonical text of one of its scenes, which is made once.
  const std::string& text(const std::string& name) const;
  /// Names, titles and descriptions as JSON.
  const std::string& listing() const;
  static Value listing_schema(Definitions& named);

 private:
  struct Entry {
    explicit Entry(std::string_view bytes) : json(bytes) {}
    const std::string_view json;
    std::once_flag is_read{}, is_written{};
    KnownScene scene{};
    std::string text{};
  };
  mutable std::map<std::string, Entry, std::less<>> entries_;
  mutable std::once_flag is_listed_;
  mutable std::string listing_;
};

}  // namespace tia::server
