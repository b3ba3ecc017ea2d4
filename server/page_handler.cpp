// The page and its files, from memory.
#include "server/assets.h"
#include "server/digest.h"
#include "server/handlers.h"
#include "server/problem.h"

namespace tia::server {

Response get_page(const Request& request, const std::string&, Service&) {
  return get_asset(request, "/index.html");
}

Response get_asset(const Request& request, std::string_view path) {
  const Asset* asset = find_asset(path);
  if (asset == nullptr) throw HttpError("not-found", "no such path");
  const std::string etag = '"' + sha256_hex(asset->bytes) + '"';
  const Headers headers{{"ETag", etag}, {"Cache-Control", "no-cache"}};
  const std::string_view seen = request.header("If-None-Match");
  if (seen == "*" || seen.find(etag) != std::string_view::npos)
    return {.status = 304, .content_type = "", .body = "", .headers = headers};
  return {.content_type = std::string(media_type(path)),
          .body = std::string(asset->bytes),
          .headers = headers};
}

}  // namespace tia::server
