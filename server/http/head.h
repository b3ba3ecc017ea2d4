// The head of an HTTP/1 message, read strictly: whatever two readers could understand differently
// is refused (RFC 9112, 11.2: request smuggling).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "server/http/message.h"

namespace tia::server {

/// Head: a request but for its body, and how that comes.
struct Head {
  enum class Body { none, sized, chunked };

  std::string method, target;
  Headers headers;
  Body body = Body::none;
  std::int64_t length = 0;  ///< of a sized body, in bytes
  bool is_http_1_0 = false;
  bool keep_alive = true;
  bool expects_continue = false;  ///< the client waits for 100 before it sends the body

  static constexpr std::size_t most_bytes = 16 << 10, most_fields = 100;
};

/// Reads a head from its first byte to its empty line. Errors: HttpError.
Head read_head(std::string_view text);

/// Reads the fields of a head or of a chunked body's trailer, up to the empty line that ends them.
/// Errors: HttpError.
Headers read_fields(std::string_view text);

/// BodyLimit: how long a body may be, and the option that says so.
struct BodyLimit {
  std::int64_t most_bytes = 0;
  const char* option = "TIA_MAX_BODY_BYTES";
};

/// Refuses a body that is longer. Errors: HttpError.
void check_length(std::uint64_t size, const BodyLimit& limit);

/// Refuses lines, or a first part of them, that hold what no head may: control characters, line
/// ends that are not CR LF. Looks from the byte at `from` on. Errors: HttpError.
void check_lines(std::string_view text, std::size_t from = 0);

}  // namespace tia::server
