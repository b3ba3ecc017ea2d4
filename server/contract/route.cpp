#include "server/contract/route.h"

#include "core/input/object_schema.h"

namespace tia::server {

Value segment_schema(const Route& route) {
  if (route.segments.empty()) return plain_schema<std::string>();
  return Value::Object{{"enum", Value::Array(route.segments.begin(), route.segments.end())}};
}

}  // namespace tia::server
