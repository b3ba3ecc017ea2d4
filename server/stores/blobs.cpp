#include "server/stores/blobs.h"

#include <algorithm>
#include <stdexcept>

#include "server/stores/digest.h"

namespace tia::server {
namespace {

// AWS, "Bucket naming rules": 3 to 63 of these; a prefix of what needs no escape.
bool is_bucket(std::string_view name) {
  return name.size() >= 3 && name.size() <= 63 &&
         name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789.-") == name.npos;
}
bool is_prefix(std::string_view prefix) {
  return std::all_of(prefix.begin(), prefix.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("-_./").find(c) != std::string_view::npos;
  });
}

}  // namespace

std::optional<std::string> checked_blob(Blobs& blobs, const std::string& name,
                                        std::string_view sha256) {
  constexpr int looks = 3;  // bits flip on the way, too
  for (int i = 0; i < looks; ++i) {
    auto bytes = blobs.find(name);
    if (!bytes) return std::nullopt;
    if (sha256_hex(*bytes) == sha256) return bytes;
  }
  return std::nullopt;
}

std::unique_ptr<Blobs> blobs_at(const std::string& url, const S3Options& s3) {
  constexpr std::string_view folder = "dir:", bucket = "s3://";
  if (url.starts_with(folder)) return blobs_in_folder(url.substr(folder.size()));
  const std::string place = url.starts_with(bucket) ? url.substr(bucket.size()) : "";
  const std::string name = place.substr(0, place.find('/'));
  std::string prefix = place.substr(std::min(place.size(), name.size() + 1));
  while (prefix.ends_with('/')) prefix.pop_back();
  if (!is_bucket(name) || !is_prefix(prefix))
    throw std::invalid_argument("got " + url + ", allowed: " + std::string(allowed_store));
  return blobs_in_s3(name, prefix, s3);
}

HttpError store_full() {
  return {"storage-full", "the store of results has no room (option TIA_STORE)"};
}

}  // namespace tia::server
