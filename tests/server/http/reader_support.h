// What comes out of a RequestReader when bytes are fed to it, in one piece or in many, as plain
// text that tests can compare.
#pragma once

#include <algorithm>
#include <ostream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "server/http/request_reader.h"
#include "server/problem.h"

namespace tia::test {

using namespace tia::server;

using Pieces = std::vector<std::string_view>;

inline constexpr std::int64_t ordinary_body = 4 << 20;

/// All that the rest of the server may see of a request, but its random id.
inline std::string summary(const Request& request, bool keep_alive) {
  std::string text = request.method + " " + request.target;
  text += request.is_http_1_0 ? " 1.0" : " 1.1";
  text += keep_alive ? " keep\n" : " close\n";
  for (const auto& [name, value] : request.headers) text.append(name + "|" + value + "\n");
  return text + "\n" + request.body;
}

/// ReadOut: requests in order, then the status and type of the refusal that ended it, or 0, "".
struct ReadOut {
  std::vector<std::string> requests;
  int status = 0;
  std::string type;
  RequestReader::State state = RequestReader::State::idle;  ///< at the end, where nothing was wrong

  bool operator==(const ReadOut&) const = default;
};
inline void PrintTo(const ReadOut& read, std::ostream* out) {
  *out << read.requests.size() << " requests, then " << read.status << " " << read.type
       << ", state " << static_cast<int>(read.state);
  for (const std::string& request : read.requests) *out << "\n" << request.substr(0, 400);
}

inline ReadOut read_pieces(const Pieces& pieces, std::int64_t most_body = ordinary_body) {
  using State = RequestReader::State;
  RequestReader reader(most_body);
  ReadOut out;
  try {
    for (const std::string_view piece : pieces) {
      reader.feed(piece);
      while (reader.read() == State::whole) {
        const bool keep_alive = reader.keep_alive();
        out.requests.push_back(summary(reader.take(), keep_alive));
      }
    }
    out.state = reader.state();
  } catch (const HttpError& error) {
    out.type = error.type();
    out.status = problem_response(std::current_exception(), reader.request()).status;
  }
  return out;
}

inline ReadOut read_whole(std::string_view bytes, std::int64_t most_body = ordinary_body) {
  return read_pieces({bytes}, most_body);
}

inline Pieces bytes_of(std::string_view text) {
  Pieces pieces;
  for (std::size_t i = 0; i < text.size(); ++i) pieces.push_back(text.substr(i, 1));
  return pieces;
}

/// Pieces of random lengths: most are short, so that they split what belongs together.
inline Pieces random_pieces(std::string_view text, std::mt19937& random) {
  Pieces pieces;
  while (!text.empty()) {
    const std::size_t most = random() % 4 == 0 ? 4000 : 12;
    const std::size_t size = std::min<std::size_t>(random() % most, text.size());
    pieces.push_back(text.substr(0, size));
    text.remove_prefix(size);
  }
  return pieces;
}

}  // namespace tia::test
