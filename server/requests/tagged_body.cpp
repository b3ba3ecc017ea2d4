#include "server/requests/tagged_body.h"

#include "server/requests/etag.h"
#include "server/stores/digest.h"

namespace tia::server {

TaggedBody::TaggedBody(std::string_view sent) : bytes(sent), etag('"' + sha256_hex(sent) + '"') {}

Response tagged_response(const Request& request, const TaggedBody& body,
                         std::string_view media_type) {
  const Headers headers{{"ETag", body.etag}, {"Cache-Control", "no-cache"}};
  if (has_already(request, body.etag))
    return {.status = 304, .content_type = "", .body = "", .headers = headers};
  return {
      .content_type = std::string(media_type), .body = std::string(body.bytes), .headers = headers};
}

}  // namespace tia::server
