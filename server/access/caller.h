// Whom a request says it is from, and whether that holds.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "server/access/key_ring.h"

namespace tia::server {

struct Request;

/// Caller: whom a request is from, where it says so: by a key, or by a URL that one has signed.
struct Caller {
  std::shared_ptr<const KeyEntry> entry = nullptr;  ///< null where what it says does not hold
  std::optional<std::int64_t> signed_until = {};    ///< seconds since 1970; none: by a key
  std::string_view why = {};                        ///< what does not hold, in a word
  std::string detail = {};                          ///< the same in words
};

/// The caller by the request's signature, which is taken off its target, or by its key; null where
/// it has neither, or the ring knows no keys. Unit: seconds since 1970.
std::shared_ptr<const Caller> take_caller(Request& request,
                                          const std::shared_ptr<const KeyRing>& ring,
                                          std::int64_t seconds);

}  // namespace tia::server
