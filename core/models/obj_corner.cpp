#include "core/models/obj_corner.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace tia {
namespace {

using ObjIndexFault = std::optional<FaultKind>;

bool is_obj_digit(char c) { return c >= '0' && c <= '9'; }

// Takes an index of so many off a text. By hand: there are millions of them, and all are short.
ObjIndexFault take_obj_index(const char*& at, const char* end, std::size_t count,
                             std::uint32_t& index) {
  constexpr std::ptrdiff_t most_digits = 18;  // so many a number can always hold
  const bool is_back = at != end && *at == '-';
  if (is_back) ++at;
  const char* const digits = at;
  std::uint64_t number = 0;
  for (; at != end && is_obj_digit(*at); ++at)
    number = 10 * number + static_cast<unsigned>(*at - '0');
  if (at == digits) return FaultKind::malformed;
  if (number == 0 || number > count || at - digits > most_digits) return FaultKind::out_of_range;
  index = static_cast<std::uint32_t>(is_back ? count - number : number - 1);
  return std::nullopt;
}

}  // namespace

std::optional<FaultKind> take_obj_corner(ObjWords& words, const ObjCounts& counts,
                                         ObjCorner& corner) {
  const std::string_view text = words.left();
  const char *at = text.data(), *const end = at + text.size();
  if (const auto fault = take_obj_index(at, end, counts[0], corner.position)) return fault;
  for (std::size_t k = 1; k < 3 && at != end && *at == '/'; ++k) {
    ++at;
    if (at == end || (*at != '-' && !is_obj_digit(*at))) continue;  // none, or told below
    std::uint32_t& index = k == 1 ? corner.uv : corner.normal;
    if (const auto fault = take_obj_index(at, end, counts[k], index)) return fault;
  }
  if (!words.skip(static_cast<std::size_t>(at - text.data()))) return FaultKind::malformed;
  return std::nullopt;
}

std::string obj_corner_words(FaultKind kind, const ObjCounts& counts) {
  if (kind == FaultKind::malformed) return "corners as v, v/vt, v//vn or v/vt/vn";
  return "indices from 1, or from -1 back, of the " + std::to_string(counts[0]) +
         " positions (v), " + std::to_string(counts[1]) + " texture coordinates (vt) and " +
         std::to_string(counts[2]) + " normals (vn) before it";
}

}  // namespace tia
