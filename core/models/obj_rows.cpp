#include "core/models/obj_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>

#include "core/film/tonemap.h"

namespace tia {
namespace {

constexpr double obj_most_coordinate = 1e9;

/// ObjRow: the numbers of a line; after a fault there are none, and all are 0.
struct ObjRow {
  std::array<double, 6> numbers{};
  std::size_t count = 0;
  double operator[](std::size_t i) const { return numbers[i]; }
};

ObjRow refuse_obj_row(FaultKind kind, std::string_view got, const char* allowed,
                      ObjReading& reading) {
  reading.fault(kind, got, allowed);
  return {};
}

// As many numbers as there may be, up to 6 of them: bit n of `counts`.
ObjRow read_obj_row(ObjWords words, unsigned counts, const char* allowed, ObjReading& reading) {
  ObjRow row;
  for (; !words.empty() && row.count < row.numbers.size(); ++row.count) {
    const ObjNumber got = words.take(row.numbers[row.count]);
    if (got == ObjNumber::taken) continue;
    return refuse_obj_row(
        got == ObjNumber::too_large ? FaultKind::out_of_range : FaultKind::malformed, words.take(),
        allowed, reading);
  }
  if (!words.empty() || (counts >> row.count & 1U) == 0)
    return refuse_obj_row(FaultKind::malformed, reading.line(), allowed, reading);
  return row;
}
constexpr unsigned obj_counts(std::initializer_list<unsigned> counts) {
  unsigned bits = 0;
  for (const unsigned count : counts) bits |= 1U << count;
  return bits;
}

bool has_obj_room(std::size_t rows, const char* what, ObjReading& reading) {
  if (rows < reading.limits().vertices) return true;
  reading.stop(reading.line(), reading.limits().vertices, what);
  return false;
}

// Of the last position; those before it may have had none, and it may have none.
void add_obj_color(std::span<const double> signals, ObjReading& reading, ObjContent& content) {
  content.colors.resize(content.positions.size(), std::numeric_limits<float>::quiet_NaN());
  float* color = content.colors.data() + content.colors.size() - 3;
  for (const double signal : signals) {
    const double clamped = std::clamp(signal, 0.0, 1.0);
    if (clamped != signal)
      reading.warn_once("v", "v: a colour outside 0 to 1 is taken as the nearest of these");
    *color++ = static_cast<float>(srgb_to_linear(clamped));
  }
}

}  // namespace

void read_obj_position(ObjWords words, ObjReading& reading, ObjContent& content) {
  static constexpr const char* allowed =
      "v and x y z, each within 1e9 of 0, then nothing, w, or r g b";
  if (!has_obj_room(content.positions.size() / 3, "positions (v)", reading)) return;
  ObjRow row = read_obj_row(words, obj_counts({3, 4, 6}), allowed, reading);
  const auto is_far = [](double x) { return std::fabs(x) > obj_most_coordinate; };
  if (is_far(row[0]) || is_far(row[1]) || is_far(row[2]))
    row = refuse_obj_row(FaultKind::out_of_range, reading.line(), allowed, reading);
  reading.make_room(3, content.positions);
  for (std::size_t i = 0; i < 3; ++i) content.positions.push_back(row[i]);
  if (row.count == 6) add_obj_color(std::span(row.numbers).last(3), reading, content);
  else if (!content.colors.empty()) add_obj_color({}, reading, content);
}

void read_obj_uv(ObjWords words, ObjReading& reading, ObjContent& content) {
  if (!has_obj_room(content.uvs.size() / 2, "texture coordinates (vt)", reading)) return;
  const ObjRow row =
      read_obj_row(words, obj_counts({1, 2, 3}), "vt and u, u v or u v w, finite numbers", reading);
  reading.make_room(2, content.uvs);
  content.uvs.push_back(row[0]);
  content.uvs.push_back(1 - row[1]);
}

void read_obj_normal(ObjWords words, ObjReading& reading, ObjContent& content) {
  static constexpr const char* allowed = "vn and x y z, finite in single precision";
  if (!has_obj_room(content.normals.size() / 3, "normals (vn)", reading)) return;
  ObjRow row = read_obj_row(words, obj_counts({3}), allowed, reading);
  const auto is_infinite = [](double x) { return std::isinf(static_cast<float>(x)); };
  if (is_infinite(row[0]) || is_infinite(row[1]) || is_infinite(row[2]))
    row = refuse_obj_row(FaultKind::out_of_range, reading.line(), allowed, reading);
  reading.make_room(3, content.normals);
  bool is_zero = true;
  for (std::size_t i = 0; i < 3; ++i) {
    content.normals.push_back(static_cast<float>(row[i]));
    is_zero = is_zero && content.normals.back() == 0;
  }
  if (!is_zero || row.count == 0) return;
  content.has_zero_normals = true;
  reading.warn_once("vn", "vn: a normal of length 0: parts that use it have no normals");
}

}  // namespace tia
