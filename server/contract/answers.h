// Words for what routes answer: what several of them say alike.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "server/contract/contract.h"

namespace tia::server {

namespace media {
inline constexpr std::string_view json = "application/json";
inline constexpr std::string_view json_schema = "application/schema+json";  // which is JSON, too
inline constexpr std::string_view png = "image/png";
inline constexpr std::string_view html = "text/html; charset=utf-8";
}  // namespace media

inline Answer ok(std::string_view about, std::string_view type, MakeSchema schema,
                 std::vector<std::string_view> headers = {}) {
  return {200, about, {{type, schema}}, std::move(headers)};
}
/// JSON that no cache may keep.
inline Answer unstored(std::string_view about, MakeSchema schema) {
  return ok(about, media::json, schema, {"Cache-Control"});
}
/// What is sent with a tag, and not again to who has it.
inline std::vector<Answer> tagged(std::string_view about, std::vector<Content> contents) {
  return {{200, about, std::move(contents), {"ETag", "Cache-Control", "Content-Encoding"}},
          {304, "If-None-Match names its tag", {}, {"ETag", "Cache-Control"}}};
}

}  // namespace tia::server
