// Bytes that are made once and sent with a tag, and not again to who has them.
#pragma once

#include <string>
#include <string_view>

#include "server/http/message.h"

namespace tia::server {

/// TaggedBody: a body as it is sent, and the tag of these bytes.
struct TaggedBody {
  explicit TaggedBody(std::string_view sent);
  std::string_view bytes;
  std::string etag;
};

/// The body with its tag, or the tag alone.
Response tagged_response(const Request& request, const TaggedBody& body,
                         std::string_view media_type);

}  // namespace tia::server
