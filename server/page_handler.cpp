// The page and its files, from memory, in the coding that the client takes.
#include <map>
#include <optional>

#include "server/accept.h"
#include "server/assets.h"
#include "server/digest.h"
#include "server/etag.h"
#include "server/handlers.h"
#include "server/headers.h"
#include "server/problem.h"

namespace tia::server {
namespace {

/// Coded: a file's bytes as they are sent, and the tag of these bytes.
struct Coded {
  explicit Coded(std::string_view sent) : bytes(sent), etag('"' + sha256_hex(sent) + '"') {}
  std::string_view bytes;
  std::string etag;
};

struct Page {
  Coded plain;
  std::optional<Coded> gzip;
};

// All files with their tags, which are reckoned once.
const std::map<std::string_view, Page>& pages() {
  static const std::map<std::string_view, Page> all = [] {
    std::map<std::string_view, Page> made;
    for (const Asset& asset : assets()) {
      Page page{Coded(asset.bytes), {}};
      if (!asset.gzip.empty()) page.gzip.emplace(asset.gzip);
      made.emplace(asset.path, std::move(page));
    }
    return made;
  }();
  return all;
}

}  // namespace

Response get_page(const Request& request, const std::string&, Service&) {
  return get_asset(request, "/index.html");
}

Response get_asset(const Request& request, std::string_view path) {
  const auto found = pages().find(path);
  if (found == pages().end()) throw HttpError("not-found", "no such path");
  const Page& page = found->second;
  const bool zipped = page.gzip && takes_coding(request, "gzip");
  const Coded& sent = zipped ? *page.gzip : page.plain;
  Headers headers{{"ETag", sent.etag}, {"Cache-Control", "no-cache"}};
  if (page.gzip) add_vary(headers, "Accept-Encoding");
  if (has_already(request, sent.etag))
    return {.status = 304, .content_type = "", .body = "", .headers = headers};
  if (zipped) headers.emplace_back("Content-Encoding", "gzip");
  return {.content_type = std::string(media_type(path)),
          .body = std::string(sent.bytes),
          .headers = headers};
}

}  // namespace tia::server
