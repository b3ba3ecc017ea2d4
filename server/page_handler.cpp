// The page and its files, from memory, in the coding that the client takes.
#include <algorithm>
#include <map>
#include <optional>

#include "server/accept.h"
#include "server/assets.h"
#include "server/handlers.h"
#include "server/headers.h"
#include "server/problem.h"
#include "server/tagged.h"

namespace tia::server {
namespace {

struct Page {
  Tagged plain;
  std::optional<Tagged> gzip;
};

// All files with their tags, which are reckoned once.
const std::map<std::string_view, Page>& pages() {
  static const std::map<std::string_view, Page> all = [] {
    std::map<std::string_view, Page> made;
    for (const Asset& asset : assets()) {
      Page page{Tagged(asset.bytes), {}};
      if (!asset.gzip.empty()) page.gzip.emplace(asset.gzip);
      made.emplace(asset.path, std::move(page));
    }
    return made;
  }();
  return all;
}

// The gallery's files do not: they are answered as /scenes/NAME.
bool stands_at_root(const Asset& asset) { return asset.path.rfind('/') == 0; }

Response file_response(const Request& request, std::string_view path) {
  const auto found = pages().find(path);
  if (found == pages().end()) throw HttpError("not-found", "no such path");
  const Page& page = found->second;
  const bool zipped = page.gzip && takes_coding(request, "gzip");
  Response response = tagged_response(request, zipped ? *page.gzip : page.plain, media_type(path));
  if (page.gzip) add_vary(response.headers, "Accept-Encoding");
  if (zipped && response.status == 200) response.headers.emplace_back("Content-Encoding", "gzip");
  return response;
}

}  // namespace

Response get_page(const Request& request, const std::string&, Service&) {
  return file_response(request, "/index.html");
}

Response get_page_file(const Request& request, const std::string&, Service&) {
  return file_response(request, request.path());
}

bool is_page_file(std::string_view name) { return find_asset('/' + std::string(name)) != nullptr; }

Value page_file_schema(Definitions&) {
  Value::Array names;
  for (const Asset& asset : assets())
    if (stands_at_root(asset)) names.emplace_back(asset.path.substr(1));
  return Value::Object{{"enum", names}};
}

std::vector<Content> page_file_contents() {
  std::vector<Content> contents;
  for (const Asset& asset : assets()) {
    const std::string_view type = media_type(asset.path);
    const auto same = [&](const Content& each) { return each.type == type; };
    if (stands_at_root(asset) && std::none_of(contents.begin(), contents.end(), same))
      contents.push_back({type});
  }
  return contents;
}

}  // namespace tia::server
