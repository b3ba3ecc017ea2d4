// Requests that must be refused, because two readers could understand them differently or because
// they are no HTTP/1.1 at all, and with which status.
// Source: RFC 9112, 2.2, 3, 5, 6, 7, 11.2; J. Kettle, HTTP desync attacks, 2019.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace tia::test {

struct BadRequest {
  const char* law;
  std::string bytes;
  int status;
};
void PrintTo(const BadRequest& bad, std::ostream* out);

/// All of them.
const std::vector<BadRequest>& bad_requests();

}  // namespace tia::test
