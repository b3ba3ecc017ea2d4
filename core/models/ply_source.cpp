#include "core/models/ply_source.h"

#include <cmath>
#include <utility>

namespace tia {
namespace {

struct PlyRange {
  double least, most;
};
// Domain: a type of whole numbers.
PlyRange ply_range(PlyType type) {
  const double count = size_of(type) == 1 ? 0x1p8 : size_of(type) == 2 ? 0x1p16 : 0x1p32;
  const bool is_signed = type == PlyType::int8 || type == PlyType::int16 || type == PlyType::int32;
  return is_signed ? PlyRange{-count / 2, count / 2 - 1} : PlyRange{0, count - 1};
}

}  // namespace

bool PlyText::begin_row() {
  while (!left_.empty()) {
    row_ = cut_line(left_, line_end_);
    ++line_;
    if (!trimmed(row_).empty()) return true;
  }
  return refuse(FaultKind::malformed, "the end of the file", "a line");
}

bool PlyText::end_row() {
  const std::string_view word = cut_word(row_);
  return word.empty() || refuse(FaultKind::malformed, word, "the end of the line");
}

bool PlyText::read(PlyType type, double& number) {
  const std::string_view word = cut_word(row_);
  if (word.empty()) return refuse(FaultKind::malformed, "the end of the line", "a number");
  const std::optional<double> read = number_in(word);
  if (!read) return refuse(FaultKind::malformed, word, "a number");
  number = *read;
  if (!is_whole(type)) return true;
  const PlyRange range = ply_range(type);
  return (number >= range.least && number <= range.most && std::floor(number) == number) ||
         refuse(FaultKind::out_of_range, word,
                "a whole number from " + std::to_string(static_cast<std::int64_t>(range.least)) +
                    " to " + std::to_string(static_cast<std::int64_t>(range.most)));
}

bool PlyText::skip(PlyType, std::uint64_t count) {
  for (; count > 0; --count)
    if (cut_word(row_).empty())
      return refuse(FaultKind::malformed, "the end of the line", "a number");
  return true;
}

bool PlyText::refuse(FaultKind kind, std::string_view got, std::string allowed) {
  trouble_ = {kind, Value(got), std::move(allowed)};
  return false;
}

}  // namespace tia
