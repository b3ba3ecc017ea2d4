// What tests of live pictures share: parts taken off a connection as they come.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "core/film/jpeg.h"
#include "tests/core/png/png_reader.h"
#include "tests/server/http/parts_support.h"

namespace tia::test {

/// The JPEG of a PNG's pixels.
inline std::string jpeg_of(const std::string& png) {
  const Png read = read_png(png);
  Image8 image(read.width, read.height);
  image.rgb.assign(read.rgb.begin(), read.rgb.end());
  return encode_jpeg(image);
}

/// LivePart: one of a multipart body.
struct LivePart {
  std::string head, body;
  std::string field(const std::string& name) const {
    const std::size_t at = head.find(name + ": ") + name.size() + 2;
    EXPECT_NE(head.find(name + ": "), head.npos) << name;
    return head.substr(at, head.find("\r\n", at) - at);
  }
  int number(const std::string& name) const { return std::stoi(field(name)); }
};

/// LiveWire: a client that looks on.
class LiveWire {
 public:
  explicit LiveWire(int port, int receive_buffer = 0) : wire_(port, receive_buffer) {}

  void get(const std::string& target) {
    wire_.get(target);
    head_ = wire_.until("\r\n\r\n");
    EXPECT_THAT(head_, testing::StartsWith("HTTP/1.1 200 "));
  }
  void leave() { wire_.leave(); }
  bool has_more(milliseconds wait) const { return !data_.empty() || wire_.readable(wait); }
  /// The next part; nothing once there is none any more.
  std::optional<LivePart> next() {
    if (!has_begun_) take_line();
    has_begun_ = true;
    if (ended_) return std::nullopt;
    LivePart part;
    if (!fill([&] { return data_.find("\r\n\r\n") != data_.npos; })) return std::nullopt;
    part.head = data_.substr(0, data_.find("\r\n\r\n") + 2);
    data_.erase(0, part.head.size() + 2);
    const auto size = static_cast<std::size_t>(part.number("Content-Length"));
    if (!fill([&] { return data_.size() >= size + 2; })) return std::nullopt;
    part.body = data_.substr(0, size);
    data_.erase(0, size + 2);
    ended_ = take_line().ends_with("--");
    return part;
  }
  /// Whether it ended as such an answer does: with its last boundary and the last chunk.
  bool is_whole() {
    fill([] { return false; });
    return ended_ && whole_ && data_.empty();
  }

 private:
  template <class Enough>
  bool fill(const Enough& enough) {
    while (!enough()) {
      if (whole_) return false;
      const std::string size = wire_.until("\r\n");
      if (size.empty()) return false;
      const std::size_t bytes = std::stoul(size, nullptr, 16) + 2;
      whole_ = bytes == 2;
      std::string chunk;
      while (chunk.size() < bytes) {
        const std::string more = wire_.read(bytes - chunk.size());
        if (more.empty()) return false;
        chunk += more;
      }
      data_.append(chunk, 0, bytes - 2);
    }
    return true;
  }
  std::string take_line() {
    if (!fill([&] { return data_.find("\r\n") != data_.npos; })) return "";
    std::string line = data_.substr(0, data_.find("\r\n"));
    EXPECT_THAT(line, testing::StartsWith("--tia-"));
    data_.erase(0, line.size() + 2);
    return line;
  }

  Wire wire_;
  std::string head_, data_;
  bool has_begun_ = false, ended_ = false, whole_ = false;
};

}  // namespace tia::test
