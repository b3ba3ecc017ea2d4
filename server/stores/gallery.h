// The gallery: the scenes that come with the server, by name.
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "server/stores/known_scene.h"

namespace tia::server {

class Gallery {
 public:
  /// Reads every embedded /scenes/NAME.json. Errors: InputError for one that is no scene.
  Gallery();
  const std::map<std::string, KnownScene, std::less<>>& scenes() const { return scenes_; }
  /// The scene of that name, or null.
  KnownScene find(std::string_view name) const;
  std::vector<std::string_view> names() const;
  /// The canonical text of one of its scenes, which is made once. Any thread may call.
  const std::string& text(const std::string& name) const;
  /// Names, titles and descriptions as JSON.
  const std::string& listing() const { return listing_; }
  static Value listing_schema(Definitions& named);

 private:
  struct Text {
    std::once_flag made;
    std::string text;
  };
  std::map<std::string, KnownScene, std::less<>> scenes_;
  mutable std::map<std::string, Text> texts_;
  std::string listing_;
};

}  // namespace tia::server
