#include "server/requests/etag.h"

#include <string>

#include "server/http/headers.h"

namespace tia::server {
namespace {

std::string_view opaque(std::string_view etag) {
  return etag.starts_with("W/") ? etag.substr(2) : etag;
}

}  // namespace

bool has_already(const Request& request, std::string_view etag) {
  const std::string list = joined(request, "If-None-Match");
  const std::string_view wanted = opaque(etag);
  std::string_view left = list;
  if (left == "*") return true;
  // Commas may stand inside of tags: quotes part the list.
  for (auto open = left.find('"'); open != left.npos; open = left.find('"')) {
    const auto close = left.find('"', open + 1);
    if (close == left.npos) return false;
    if (left.substr(open, close - open + 1) == wanted) return true;
    left.remove_prefix(close + 1);
  }
  return false;
}

}  // namespace tia::server
