// What targets have led to: a GET that has been answered with a picture once need not be read again
// to know what the picture is called. Any thread may call.
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "server/http/message.h"
#include "server/operation/lru_map.h"

namespace tia::server {

/// KnownTarget: what is said of a target's picture, whether it is sent or not.
struct KnownTarget {
  std::string etag, scene, content_type;  ///< scene: the name that the request gives
  Headers validators, beside;             ///< beside: what a 304 does without
};

class KnownTargets {
 public:
  static constexpr std::size_t most_bytes = 4 << 20;  ///< of names and what is known of them

  std::optional<KnownTarget> find(const std::string& name);
  void keep(const std::string& name, KnownTarget known);

  /// What tells a request for a picture from others whose pictures may be others: its target, and
  /// what it accepts.
  static std::string name_of(const Request& request);

 private:
  std::mutex mutex_;
  LruMap<std::string, KnownTarget> targets_;
  std::size_t bytes_ = 0;
};

}  // namespace tia::server
