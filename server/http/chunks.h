// A chunked body (RFC 9112, 7.1), taken apart as its bytes come.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "server/http/head.h"

namespace tia::server {

class ChunkDecoder {
 public:
  explicit ChunkDecoder(BodyLimit limit) : limit_(limit) {}

  /// Longest line of a size with its extensions, and all lines of the trailer, in bytes.
  static constexpr std::size_t longest_line = 256, most_trailer = 4096;

  /// Takes what it can off the bytes' front and adds the data to the body. Domain: bytes that no
  /// line of the framing splits are offered again, with what follows them.
  /// Returns: whether the body has ended. Errors: HttpError.
  bool decode(std::string_view& bytes, std::string& body);

 private:
  enum class At { size, data, data_end, trailer };
  bool take_size(std::string_view& bytes);
  bool take_data(std::string_view& bytes, std::string& body);
  bool take_data_end(std::string_view& bytes);
  bool take_trailer(std::string_view& bytes);

  BodyLimit limit_;
  At at_ = At::size;
  std::uint64_t left_ = 0, all_ = 0;  // of the chunk's data; and of all chunks so far
  bool ended_ = false;
};

}  // namespace tia::server
