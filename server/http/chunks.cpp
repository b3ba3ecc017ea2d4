#include "server/http/chunks.h"

#include <algorithm>
#include <charconv>

#include "server/http/error.h"
#include "server/http/head.h"

namespace tia::server {
namespace {

[[noreturn]] void malformed(const char* detail) { throw HttpError("malformed", detail); }

std::uint64_t size_of(std::string_view line) {
  std::uint64_t size = 0;
  const auto parsed = std::from_chars(line.data(), line.data() + line.size(), size, 16);
  const std::string_view rest = line.substr(static_cast<std::size_t>(parsed.ptr - line.data()));
  constexpr std::uint64_t most = 1ULL << 40U;
  if (parsed.ec != std::errc() || size > most || (!rest.empty() && rest[0] != ';'))
    malformed("a chunk's size must be hexadecimal digits");
  return size;
}

}  // namespace

bool ChunkDecoder::decode(std::string_view& bytes, std::string& body) {
  bool more = true;
  while (more && !ended_) switch (at_) {
      case At::size: more = take_size(bytes); break;
      case At::data: more = take_data(bytes, body); break;
      case At::data_end: more = take_data_end(bytes); break;
      case At::trailer: more = take_trailer(bytes); break;
    }
  return ended_;
}

bool ChunkDecoder::take_size(std::string_view& bytes) {
  const std::string_view start = bytes.substr(0, longest_line);
  const auto end = start.find("\r\n");
  check_lines(start.substr(0, end == start.npos ? end : end + 2));
  if (end == start.npos) {
    if (start.size() == longest_line) malformed("the line of a chunk's size is too long");
    return false;
  }
  left_ = size_of(bytes.substr(0, end));
  check_length(all_ += left_, limit_);
  at_ = left_ == 0 ? At::trailer : At::data;
  bytes.remove_prefix(left_ == 0 ? end : end + 2);  // a trailer ends with an empty line
  return true;
}

bool ChunkDecoder::take_data(std::string_view& bytes, std::string& body) {
  const auto size = static_cast<std::size_t>(std::min<std::uint64_t>(left_, bytes.size()));
  body.append(bytes.substr(0, size));
  bytes.remove_prefix(size);
  left_ -= size;
  if (left_ > 0) return false;
  at_ = At::data_end;
  return true;
}

bool ChunkDecoder::take_data_end(std::string_view& bytes) {
  const std::string_view end = bytes.substr(0, 2);
  if (end != std::string_view("\r\n").substr(0, end.size()))
    malformed("a chunk is longer than its size");
  if (end.size() < 2) return false;
  bytes.remove_prefix(2);
  at_ = At::size;
  return true;
}

bool ChunkDecoder::take_trailer(std::string_view& bytes) {
  const std::string_view start = bytes.substr(0, most_trailer);
  const auto end = start.find("\r\n\r\n");
  check_lines(start.substr(0, end == start.npos ? end : end + 4));
  if (end == start.npos) {
    if (start.size() == most_trailer)
      throw HttpError("header-too-large", "the trailer is too long");
    return false;
  }
  read_fields(start.substr(2, end + 2));  // checked, and not used
  bytes.remove_prefix(end + 4);
  return ended_ = true;
}

}  // namespace tia::server
