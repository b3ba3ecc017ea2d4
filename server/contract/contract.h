// What a request may bring and what its answer may be, as data: the routes say it, the OpenAPI
// document tells it.
#pragma once

#include <string_view>
#include <vector>

#include "core/input/codec.h"

namespace tia::server {

/// Makes a JSON Schema; what it refers to is in `named` afterwards.
using MakeSchema = Value (*)(Definitions& named);
template <class T>
Value schema_for(Definitions& named) {
  return schema_of<T>({}, named);
}

/// Example: a request's body, and what it asks for.
struct Example {
  std::string_view about, text;
};

/// Content: a body of that media type.
struct Content {
  std::string_view type;
  MakeSchema schema = nullptr;  ///< null where the type says it all
  std::vector<Example> examples = {};
  /// Headers that an answer always has with this type, and not with each of its others.
  std::vector<std::string_view> headers = {};
};

/// Answer: what a route may say, problems aside.
struct Answer {
  int status = 200;
  std::string_view about;
  std::vector<Content> contents = {};          ///< one of them; none = no body
  std::vector<std::string_view> headers = {};  ///< names of header_rows()
};

/// Segment: what the {} of a path stands for.
struct Segment {
  std::string_view name, about;
};

}  // namespace tia::server
