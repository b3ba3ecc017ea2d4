#include "server/handlers/mixed_parts.h"

namespace tia::server::mixed_parts {

std::string part(std::string_view type, const Headers& fields, std::string_view body,
                 bool is_last) {
  std::string part("Content-Type: ");
  part.reserve(body.size() + 1024);
  part.append(type).append("\r\nContent-Length: ").append(std::to_string(body.size()));
  for (const auto& [name, value] : fields)
    part.append("\r\n").append(name).append(": ").append(value);
  part.append("\r\n\r\n").append(body);
  return part.append("\r\n").append(boundary).append(is_last ? "--\r\n" : "\r\n");
}

std::string problem(const std::string& document) {
  return part("application/problem+json", {}, document, true);
}

}  // namespace tia::server::mixed_parts
