#include "tests/server/http/reader_support.h"

#include <algorithm>
#include <exception>
#include <ostream>

namespace tia::test {

std::string summary(const Request& request, bool keep_alive) {
  std::string text = request.method + " " + request.target;
  text += request.is_http_1_0 ? " 1.0" : " 1.1";
  text += keep_alive ? " keep\n" : " close\n";
  for (const auto& [name, value] : request.headers) text.append(name + "|" + value + "\n");
  return text + "\n" + request.body;
}

void PrintTo(const ReadOut& read, std::ostream* out) {
  *out << read.requests.size() << " requests, then " << read.status << " " << read.type
       << ", state " << static_cast<int>(read.state);
  for (const std::string& request : read.requests) *out << "\n" << request.substr(0, 400);
}

ReadOut read_pieces(const Pieces& pieces, std::int64_t most_body) {
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
ReadOut read_whole(std::string_view bytes, std::int64_t most_body) {
  return read_pieces({bytes}, most_body);
}

Pieces single_bytes(std::string_view text) {
  Pieces pieces;
  for (std::size_t i = 0; i < text.size(); ++i) pieces.push_back(text.substr(i, 1));
  return pieces;
}
Pieces random_pieces(std::string_view text, std::mt19937& random) {
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
