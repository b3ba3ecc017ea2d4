// OpenEXR files read by what the format's description says and by zlib: nothing of ours.
// Source: "OpenEXR File Layout", openexr.com.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tests/core/png/inflate.h"

namespace tia::test {

/// The number that a half's bits are: the definition, one field after the other.
inline double number_of_half(unsigned bits) {
  const int exponent = static_cast<int>(bits >> 10 & 31), fraction = static_cast<int>(bits & 1023);
  const double sign = (bits & 0x8000U) != 0 ? -1 : 1;
  if (exponent == 31) return fraction == 0 ? sign * INFINITY : NAN;
  if (exponent == 0) return sign * std::ldexp(fraction, -24);
  return sign * std::ldexp(1024 + fraction, exponent - 25);
}

/// ExrFile: one that has been read: of scan lines, or of a single tile.
struct ExrFile {
  struct Box {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // both corners are in it
    bool operator==(const Box&) const = default;
  };
  std::map<std::string, std::string> attributes;  // their bytes
  std::map<std::string, int> types;               // of the channels: uint, half, float
  std::map<std::string, std::vector<double>> numbers;
  Box data, display;
  int plain_blocks = 0, packed_blocks = 0;

  int width() const { return data.x1 - data.x0 + 1; }
  int height() const { return data.y1 - data.y0 + 1; }
};

/// Reads the file. Errors: std::runtime_error where it is none.
class ExrReader {
 public:
  explicit ExrReader(std::string_view bytes) : all_(bytes), left_(bytes) {}

  ExrFile read() {
    check(take<std::uint32_t>() == 20000630, "magic number");
    const auto version = take<std::uint32_t>();
    is_tiled_ = version == 0x202;
    check(version == 2 || is_tiled_, "version");
    read_head();
    read_blocks();
    check(left_.empty(), "bytes behind the last block");
    return std::move(file_);
  }

 private:
  static void check(bool right, const char* what) {
    if (!right) throw std::runtime_error(std::string("not OpenEXR: ") + what);
  }
  template <class T>
  static T take_from(std::string_view& bytes) {
    check(bytes.size() >= sizeof(T), "cut short");
    T number;
    std::memcpy(&number, bytes.data(), sizeof number);
    bytes.remove_prefix(sizeof number);
    return number;
  }
  template <class T>
  T take() {
    return take_from<T>(left_);
  }
  static std::string take_name(std::string_view& bytes) {
    const auto end = bytes.find('\0');
    check(end != bytes.npos, "a name without end");
    std::string name(bytes.substr(0, end));
    bytes.remove_prefix(end + 1);
    return name;
  }
  std::string_view take_bytes(std::size_t count) {
    check(left_.size() >= count, "cut short");
    const std::string_view bytes = left_.substr(0, count);
    left_.remove_prefix(count);
    return bytes;
  }

  void read_head() {
    for (std::string name = take_name(left_); !name.empty(); name = take_name(left_)) {
      const std::string type = take_name(left_);
      const auto size = take<std::uint32_t>();
      const std::string_view value = take_bytes(size);
      check(file_.attributes.emplace(name, value).second, "an attribute twice");
      if (type == "box2i") (name == "dataWindow" ? file_.data : file_.display) = box(value);
      if (type == "chlist") read_channels(value);
    }
    const std::string compression = file_.attributes["compression"];
    check(compression == std::string(1, is_tiled_ ? '\0' : '\3'), "compression");
    check(file_.attributes["lineOrder"] == std::string(1, '\0'), "order of lines");
  }
  static ExrFile::Box box(std::string_view value) {
    ExrFile::Box box;
    for (int* each : {&box.x0, &box.y0, &box.x1, &box.y1}) *each = take_from<std::int32_t>(value);
    return box;
  }
  void read_channels(std::string_view list) {
    for (std::string name = take_name(list); !name.empty(); name = take_name(list)) {
      check(order_.empty() || order_.back() < name, "channels are sorted");
      order_.push_back(name);
      file_.types[name] = take_from<std::int32_t>(list);
      take_from<std::uint32_t>(list);
      check(take_from<std::int32_t>(list) == 1 && take_from<std::int32_t>(list) == 1, "sampling");
    }
  }

  void read_blocks() {
    const int height = file_.height(), rows = is_tiled_ ? height : 16;
    const int count = (height + rows - 1) / rows;
    std::vector<std::uint64_t> places;
    for (int i = 0; i < count; ++i) places.push_back(take<std::uint64_t>());
    for (int i = 0; i < count; ++i) {
      check(places[static_cast<std::size_t>(i)] == all_.size() - left_.size(), "a block's place");
      if (is_tiled_) take_bytes(16);
      else check(take<std::int32_t>() == file_.data.y0 + i * rows, "a block's first line");
      const auto size = take<std::uint32_t>();
      const int lines = std::min(rows, height - i * rows);
      read_lines(unpacked(take_bytes(size), lines), lines);
    }
  }
  std::string unpacked(std::string_view block, int lines) {
    std::size_t bytes = 0;
    for (const auto& [name, type] : file_.types) bytes += type == 1 ? 2 : 4;
    bytes *= static_cast<std::size_t>(lines * file_.width());
    if (block.size() == bytes) {
      ++file_.plain_blocks;
      return std::string(block);
    }
    ++file_.packed_blocks;
    std::string apart = inflated(block, bytes), together(bytes, '\0');
    check(apart.size() == bytes, "a block's size");
    for (std::size_t i = 1; i < bytes; ++i)
      apart[i] = static_cast<char>(static_cast<unsigned char>(apart[i - 1]) +
                                   static_cast<unsigned char>(apart[i]) - 128);
    for (std::size_t i = 0; i < bytes; ++i)
      together[i] = apart[i % 2 == 0 ? i / 2 : (bytes + 1) / 2 + i / 2];
    return together;
  }
  void read_lines(std::string_view lines, int count) {
    for (int y = 0; y < count; ++y)
      for (const std::string& name : order_)
        for (int x = 0; x < file_.width(); ++x)
          file_.numbers[name].push_back(number(lines, file_.types[name]));
  }
  static double number(std::string_view& from, int type) {
    if (type == 0) return take_from<std::uint32_t>(from);
    if (type == 1) return number_of_half(take_from<std::uint16_t>(from));
    check(type == 2, "a channel's type");
    return static_cast<double>(take_from<float>(from));
  }

  std::string_view all_, left_;
  ExrFile file_;
  std::vector<std::string> order_;
  bool is_tiled_ = false;
};

inline ExrFile read_exr(std::string_view bytes) { return ExrReader(bytes).read(); }

}  // namespace tia::test
