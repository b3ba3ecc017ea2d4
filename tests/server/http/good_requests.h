// Requests that must be read, each one alone: all forms that HTTP/1.1 allows.
// Source: RFC 9112.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace tia::test {

struct GoodRequest {
  const char* law;
  std::string bytes;
  std::string line;  ///< the first line of its summary
  std::string body = {};
};
void PrintTo(const GoodRequest& good, std::ostream* out);

/// All of them.
const std::vector<GoodRequest>& good_requests();

}  // namespace tia::test
