// The numbers of a PLY file's body, one after the other, in either kind of encoding. Both kinds of
// source have the same interface; rows are the text's lines.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/input/errors.h"
#include "core/models/ply_header.h"
#include "core/models/text_words.h"

namespace tia {

/// PlyTrouble: why a source does not go on.
struct PlyTrouble {
  FaultKind kind = FaultKind::malformed;
  std::optional<Value> got;
  std::string allowed;
};

/// PlyBytes: the source of the binary encodings.
template <std::endian order>
class PlyBytes {
 public:
  explicit PlyBytes(const PlyHeader& header) : left_(header.body) {}

  static bool begin_row() { return true; }
  static bool end_row() { return true; }
  /// Whether so many numbers can still follow in the row.
  bool has(PlyType type, std::uint64_t count) const {
    return count <= left_.size() / size_of(type);
  }
  bool read(PlyType type, double& number) {
    const std::size_t size = size_of(type);
    if (left_.size() < size) return false;
    number = value(type);
    left_.remove_prefix(size);
    return true;
  }
  bool skip(PlyType type, std::uint64_t count) {
    if (!has(type, count)) return false;
    left_.remove_prefix(count * size_of(type));
    return true;
  }

  /// After a step that failed.
  static PlyTrouble trouble() {
    return {FaultKind::malformed, Value("the end of the file"), "bytes of all rows"};
  }
  /// That of the present row; none where there are no lines.
  static std::optional<std::size_t> line() { return std::nullopt; }
  /// Bytes behind the last row.
  std::size_t left() const { return left_.size(); }

 private:
  template <class T>
  double as() const {
    constexpr std::size_t size = sizeof(T);
    std::conditional_t<size == 8, std::uint64_t, std::uint32_t> bits = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t shift = 8 * (order == std::endian::big ? size - 1 - i : i);
      bits |= static_cast<decltype(bits)>(static_cast<std::uint8_t>(left_[i])) << shift;
    }
    if constexpr (std::is_floating_point_v<T>) return static_cast<double>(std::bit_cast<T>(bits));
    else return static_cast<double>(static_cast<T>(bits));
  }
  double value(PlyType type) const {
    switch (type) {
      case PlyType::int8: return as<std::int8_t>();
      case PlyType::uint8: return as<std::uint8_t>();
      case PlyType::int16: return as<std::int16_t>();
      case PlyType::uint16: return as<std::uint16_t>();
      case PlyType::int32: return as<std::int32_t>();
      case PlyType::uint32: return as<std::uint32_t>();
      case PlyType::float32: return as<float>();
      case PlyType::float64: break;
    }
    return as<double>();
  }

  std::string_view left_;
};

/// PlyText: the source of the encoding `ascii`. Lines without a word are passed over.
class PlyText {
 public:
  explicit PlyText(const PlyHeader& header)
      : left_(header.body), line_end_(header.line_end), line_(header.lines) {}

  bool begin_row();
  /// Whether the row has no further word.
  bool end_row();
  bool has(PlyType, std::uint64_t count) const { return count <= row_.size() / 2; }
  /// Whole numbers are in the range of their type.
  bool read(PlyType type, double& number);
  bool skip(PlyType, std::uint64_t count);

  const PlyTrouble& trouble() const { return trouble_; }
  std::optional<std::size_t> line() const { return line_; }
  std::size_t left() const { return trimmed(left_).size(); }

 private:
  bool refuse(FaultKind kind, std::string_view got, std::string allowed);

  std::string_view left_, row_;
  char line_end_;
  std::size_t line_;
  PlyTrouble trouble_;
};

}  // namespace tia
