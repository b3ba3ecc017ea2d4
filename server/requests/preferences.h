// What a client prefers, and may go without (RFC 7240).
#pragma once

#include <optional>

#include "server/http/message.h"

namespace tia::server {

/// Preferences: those of the header Prefer that are known here; others are passed over.
struct Preferences {
  bool respond_async = false;   ///< an answer at once, of where the result will be
  std::optional<int> wait_s{};  ///< how long the answer may take
  static constexpr int longest_wait_s = 60;
};

/// Errors: InputError (out_of_range) at /Prefer for a wait that is none, or longer.
/// Source: RFC 7240, 2 and 4.
Preferences preferences_of(const Request& request);

}  // namespace tia::server
