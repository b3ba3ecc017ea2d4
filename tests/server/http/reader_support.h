// What comes out of a RequestReader when bytes are fed to it, in one piece or in many, as plain
// text that tests can compare.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "server/contract/problem.h"
#include "server/http/request_reader.h"

namespace tia::test {

using namespace tia::server;

using Pieces = std::vector<std::string_view>;

inline constexpr std::int64_t ordinary_body = 4 << 20;

/// All that the rest of the server may see of a request, but its random id.
std::string summary(const Request& request, bool keep_alive);

/// ReadOut: requests in order, then the status and type of the refusal that ended it, or 0, "".
struct ReadOut {
  std::vector<std::string> requests;
  int status = 0;
  std::string type;
  RequestReader::State state = RequestReader::State::idle;  ///< at the end, where nothing was wrong

  bool operator==(const ReadOut&) const = default;
};
void PrintTo(const ReadOut& read, std::ostream* out);

ReadOut read_pieces(const Pieces& pieces, std::int64_t most_body = ordinary_body);
ReadOut read_whole(std::string_view bytes, std::int64_t most_body = ordinary_body);

Pieces single_bytes(std::string_view text);
/// Pieces of random lengths: most are short, so that they split what belongs together.
Pieces random_pieces(std::string_view text, std::mt19937& random);

}  // namespace tia::test
