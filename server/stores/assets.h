// The page and the gallery, embedded at build time from web/: no file is opened after start.
#pragma once

#include <span>
#include <string_view>

namespace tia::server {

/// Asset: one file of web/. `path` begins with a slash: "/index.html", "/scenes/thesis.json".
struct Asset {
  std::string_view path, bytes;
  std::string_view gzip;  ///< the same compressed (RFC 1952); empty where that is no shorter
};

/// All files, sorted by path.
std::span<const Asset> assets();

/// The asset at that path, or null.
const Asset* find_asset(std::string_view path);

/// The media type that a file's name ending stands for.
std::string_view media_type(std::string_view path);

}  // namespace tia::server
