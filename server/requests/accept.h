// What a client would rather have: the weights of Accept and Accept-Encoding, in thousandths.
// Source: RFC 9110, 12.4.2 (weights), 12.5.1 (Accept), 12.5.3 (Accept-Encoding).
#pragma once

#include <string_view>
#include <vector>

#include "core/input/value.h"
#include "server/http/message.h"

namespace tia::server {

/// The weight of a media type, 0 to 1000: that of the most specific range that it falls in, 0 where
/// there is none, 1000 where the client says nothing of media types. Parameters but q are ignored.
int media_weight(const Request& request, std::string_view type);

/// Whether the client takes this content coding, and no worse than none.
bool takes_coding(const Request& request, std::string_view coding);

/// The media type of greatest weight, the first of equals. Errors: HttpError (not-acceptable).
std::string_view preferred_type(const Request& request, const std::vector<std::string_view>& types);

/// Adds to the parameters the `format` of that list that Accept prefers, where they name none.
/// Returns: whether they named none, so that the answer varies with Accept.
/// Errors: HttpError (not-acceptable).
template <class Rows>
bool choose_format(Value& parameters, const Request& request, const Rows& rows) {
  auto* object = parameters.as<Value::Object>();
  if (object == nullptr || find(*object, "format") != nullptr) return false;
  std::vector<std::string_view> types;
  for (const auto& row : rows) types.push_back(row.media_type);
  const std::string_view type = preferred_type(request, types);
  for (const auto& row : rows)
    if (row.media_type == type) return object->emplace_back("format", row.name), true;
  return false;
}

}  // namespace tia::server
