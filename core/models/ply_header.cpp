#include "core/models/ply_header.h"

#include <array>
#include <charconv>
#include <string>
#include <utility>

#include "core/models/text_words.h"

namespace tia {
namespace {

struct PlyTypeName {
  std::string_view name;
  PlyType type;
};
constexpr std::array<PlyTypeName, 16> ply_types{{{"char", PlyType::int8},
                                                 {"uchar", PlyType::uint8},
                                                 {"short", PlyType::int16},
                                                 {"ushort", PlyType::uint16},
                                                 {"int", PlyType::int32},
                                                 {"uint", PlyType::uint32},
                                                 {"float", PlyType::float32},
                                                 {"double", PlyType::float64},
                                                 {"int8", PlyType::int8},
                                                 {"uint8", PlyType::uint8},
                                                 {"int16", PlyType::int16},
                                                 {"uint16", PlyType::uint16},
                                                 {"int32", PlyType::int32},
                                                 {"uint32", PlyType::uint32},
                                                 {"float32", PlyType::float32},
                                                 {"float64", PlyType::float64}}};

std::optional<PlyType> ply_type_of(std::string_view name) {
  for (const PlyTypeName& each : ply_types)
    if (each.name == name) return each.type;
  return std::nullopt;
}

std::optional<std::uint64_t> ply_count_of(std::string_view word) {
  std::uint64_t count = 0;
  const char* const end = word.data() + word.size();
  const auto read = std::from_chars(word.data(), end, count);
  if (word.empty() || read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return count;
}

// The fewest bytes that a row takes: of a list its count; in a text a digit and a space a number.
std::size_t least_bytes(const PlyElement& element, PlyEncoding encoding) {
  std::size_t bytes = 0;
  for (const PlyProperty& property : element.properties)
    bytes += encoding == PlyEncoding::ascii ? 2 : size_of(property.count.value_or(property.type));
  return bytes;
}

class PlyHeaderReader {
 public:
  PlyHeaderReader(std::string_view file, Faults& faults) : left_(file), faults_(faults) {}

  std::optional<PlyHeader> read() {
    if (!begins_ply(left_)) {
      header_.lines = 1;
      refuse(FaultKind::malformed, left_.substr(0, 3), "a first line `ply`");
      return std::nullopt;
    }
    const std::size_t end = left_.find_first_of("\r\n");
    if (left_[end] == '\r' && left_.substr(end + 1, 1) != "\n") header_.line_end = '\r';
    bool more = true;
    while (more && !left_.empty()) {
      std::string_view line = cut_line(left_, header_.line_end);
      ++header_.lines;
      more = declare(cut_word(line), line);
    }
    if (more) refuse(FaultKind::malformed, "the end of the file", "a line `end_header`");
    if (!faults_.empty()) return std::nullopt;
    header_.body = left_;
    return check() ? std::optional(std::move(header_)) : std::nullopt;
  }

 private:
  // Whether the header goes on after a line.
  bool declare(std::string_view keyword, std::string_view rest) {
    if (keyword == "end_header") return false;
    if (keyword == "comment") return comment(rest);
    if (keyword == "obj_info" || keyword.empty() || header_.lines == 1) return true;
    if (++declared_ > most_declared)
      return refuse(FaultKind::limit, {},
                    "at most " + std::to_string(most_declared) + " elements and properties");
    if (keyword == "format") return format(rest);
    if (keyword == "element") return element(rest);
    if (keyword == "property") return property(rest);
    return refuse(FaultKind::malformed, keyword,
                  "format, comment, obj_info, element, property or end_header");
  }
  bool comment(std::string_view rest) {
    if (cut_word(rest) == "TextureFile" && header_.textures.size() < PlyHeader::most_textures)
      header_.textures.push_back({trimmed(rest), header_.lines});
    return true;
  }
  bool format(std::string_view rest) {
    const std::string_view name = cut_word(rest), version = cut_word(rest);
    if (name == "ascii") header_.encoding = PlyEncoding::ascii;
    else if (name == "binary_little_endian") header_.encoding = PlyEncoding::little_endian;
    else if (name == "binary_big_endian") header_.encoding = PlyEncoding::big_endian;
    else
      return refuse(FaultKind::malformed, name,
                    "ascii or binary_little_endian or binary_big_endian");
    if (version != "1.0") return refuse(FaultKind::malformed, version, "the version 1.0");
    if (std::exchange(has_format_, true))
      return refuse(FaultKind::conflict, name, "one line `format`");
    return ends(rest);
  }
  bool element(std::string_view rest) {
    const std::string_view name = cut_word(rest), count = cut_word(rest);
    if (name.empty()) return refuse(FaultKind::malformed, {}, "an element's name");
    const auto number = ply_count_of(count);
    if (!number) return refuse(FaultKind::malformed, count, "an element's count");
    header_.elements.push_back({name, *number, header_.lines, {}});
    return ends(rest);
  }
  bool property(std::string_view rest) {
    if (header_.elements.empty())
      return refuse(FaultKind::malformed, "property", "an element before its properties");
    PlyProperty property;
    std::string_view word = cut_word(rest);
    if (word == "list") {
      word = cut_word(rest);
      property.count = ply_type_of(word);
      if (!property.count || !is_whole(*property.count))
        return refuse(FaultKind::malformed, word, "a type of whole numbers, as of a list's count");
      word = cut_word(rest);
    }
    const auto type = ply_type_of(word);
    if (!type) return refuse(FaultKind::malformed, word, "a type, as float or uint8");
    property.type = *type;
    property.name = cut_word(rest);
    if (property.name.empty()) return refuse(FaultKind::malformed, {}, "a property's name");
    header_.elements.back().properties.push_back(property);
    return ends(rest);
  }
  bool ends(std::string_view rest) {
    const std::string_view word = cut_word(rest);
    return word.empty() || refuse(FaultKind::malformed, word, "the end of the line");
  }

  // The counts, before anything is made of them.
  bool check() {
    if (!has_format_) return refuse(FaultKind::missing, {}, "a line `format`");
    const bool is_text = header_.encoding == PlyEncoding::ascii;
    std::uint64_t left = left_.size() + (is_text ? 1 : 0);  // the last line may lack its end
    for (const PlyElement& element : header_.elements) {
      if (element.count == 0) continue;
      const std::size_t least = least_bytes(element, header_.encoding);
      if (least == 0)
        return refuse_at(element.line, FaultKind::malformed, element.name,
                         "an element with properties");
      const std::uint64_t most = left / least;
      if (element.count > most)
        return refuse_at(element.line, FaultKind::malformed, std::to_string(element.count),
                         "at most " + std::to_string(most) + ", for no more follow in the file");
      left -= element.count * least;
    }
    return true;
  }

  bool refuse(FaultKind kind, std::string_view got, std::string allowed) {
    return refuse_at(header_.lines, kind, got, std::move(allowed));
  }
  bool refuse_at(std::size_t line, FaultKind kind, std::string_view got, std::string allowed) {
    const auto came = got.empty() ? std::nullopt : std::optional(Value(got));
    faults_.add({kind, "", came, std::move(allowed), "", std::nullopt, line});
    return false;
  }

  static constexpr std::size_t most_declared = 4096;
  std::string_view left_;
  Faults& faults_;
  PlyHeader header_;
  bool has_format_ = false;
  std::size_t declared_ = 0;
};

}  // namespace

bool begins_ply(std::string_view file) {
  return file.starts_with("ply\n") || file.starts_with("ply\r");
}

std::optional<PlyHeader> read_ply_header(std::string_view file, Faults& faults) {
  return PlyHeaderReader(file, faults).read();
}

}  // namespace tia
