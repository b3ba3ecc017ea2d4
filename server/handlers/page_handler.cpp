// The pages and their files, from memory, in the coding that the client takes.
#include <algorithm>
#include <list>
#include <map>
#include <optional>

#include "server/contract/answers.h"
#include "server/handlers/handlers.h"
#include "server/http/error.h"
#include "server/http/headers.h"
#include "server/requests/accept.h"
#include "server/requests/tagged_body.h"
#include "server/stores/assets.h"

namespace tia::server {
namespace {

struct Page {
  TaggedBody plain;
  std::optional<TaggedBody> gzip;
};

// All files with their tags, which are reckoned once.
const std::map<std::string_view, Page>& pages() {
  static const std::map<std::string_view, Page> all = [] {
    std::map<std::string_view, Page> made;
    for (const Asset& asset : assets()) {
      Page page{TaggedBody(asset.bytes), {}};
      if (!asset.gzip.empty()) page.gzip.emplace(asset.gzip);
      made.emplace(asset.path, std::move(page));
    }
    return made;
  }();
  return all;
}

// Where a file lies, with a slash at its end.
std::string_view folder_of(const Asset& asset) {
  return asset.path.substr(0, asset.path.rfind('/') + 1);
}

// The gallery's files are answered as /scenes/NAME and /models/NAME.
bool of_the_gallery(const Asset& asset) {
  return folder_of(asset) == "/scenes/" || folder_of(asset) == "/models/";
}

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

Response get_page(const Request& request, const std::string&, Service&) {
  return file_response(request, "/index.html");
}

Response get_docs(const Request& request, const std::string&, Service&) {
  return file_response(request, "/docs.html");
}

Response get_page_file(const Request& request, const std::string&, Service&) {
  return file_response(request, request.path());
}

bool is_page_file(std::string_view path) {
  const Asset* asset = find_asset(path);
  return asset != nullptr && !of_the_gallery(*asset);
}

const std::vector<std::string>& page_folders() {
  static const std::vector<std::string> folders = [] {
    std::vector<std::string> found{"/"};
    for (const Asset& asset : assets())
      if (!of_the_gallery(asset) && std::ranges::find(found, folder_of(asset)) == found.end())
        found.emplace_back(folder_of(asset));
    return found;
  }();
  return folders;
}

std::vector<std::string_view> page_files(std::string_view folder) {
  std::vector<std::string_view> names;
  for (const Asset& asset : assets())
    if (folder_of(asset) == folder) names.push_back(asset.path.substr(folder.size()));
  return names;
}

std::vector<Content> page_file_contents(std::string_view folder) {
  std::vector<Content> contents;
  for (const Asset& asset : assets()) {
    const std::string_view type = media_type(asset.path);
    const auto same = [&](const Content& each) { return each.type == type; };
    if (folder_of(asset) == folder && std::ranges::none_of(contents, same))
      contents.push_back({type});
  }
  return contents;
}

// The files of one folder of the page. Paths and names must outlive the table.
Route files_of(const std::string& folder) {
  static std::list<std::string> texts;
  std::string name = "get_page_file" + folder.substr(0, folder.size() - 1);
  std::ranges::replace(name, '/', '_');
  return {.method = "GET",
          .path = texts.emplace_back(folder + "{}"),
          .name = texts.emplace_back(name),
          .about = "a file of the page",
          .handler = get_page_file,
          .answers = tagged("the file", page_file_contents(folder)),
          .segment = {"file", "its name"},
          .segments = page_files(folder),
          .has = is_page_file};
}

}  // namespace

std::vector<Route> page_routes() {
  std::vector<Route> all{{.method = "GET",
                          .path = "/docs",
                          .name = "get_docs",
                          .about = "this interface, as a page to read",
                          .handler = get_docs,
                          .answers = tagged("the page", {{media::html}})},
                         {.method = "GET",
                          .path = "/",
                          .name = "get_page",
                          .about = "the page: hold a lamp, and see why",
                          .handler = get_page,
                          .answers = tagged("the page", {{media::html}})}};
  for (const std::string& folder : page_folders()) all.push_back(files_of(folder));
  return all;
}

}  // namespace tia::server
