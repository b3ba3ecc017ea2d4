#include "core/models/ply_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace tia {
namespace {

constexpr double most_float = std::numeric_limits<float>::max();

}  // namespace

PlyVertices::PlyVertices(const PlyElement& element, const ModelLimits& limits, Faults& faults,
                         Model& model)
    : element_(element), plan_(element), faults_(faults), model_(model) {
  const std::uint64_t most =
      std::min<std::uint64_t>(limits.vertices, std::numeric_limits<std::uint32_t>::max());
  if (element.count > most)
    faults.add(ply_fault(FaultKind::limit, element, Value(std::to_string(element.count)),
                         "a model of at most " + std::to_string(most) + " vertices"));
  if (!plan_numbers({"x", "y", "z"}, x))
    faults.add(ply_fault(FaultKind::missing, element, std::nullopt,
                         "numbers x, y and z of the element vertex"));
  has_normals_ = plan_numbers({"nx", "ny", "nz"}, nx);
  has_uvs_ = plan_numbers({"s", "t"}, u) || plan_numbers({"u", "v"}, u) ||
             plan_numbers({"texture_u", "texture_v"}, u);
  plan_colors();
  warn_of_skipped(element, plan_, model);
  if (faults.empty()) reserve();
}

// The header has seen to it that the file has a byte for each number.
void PlyVertices::reserve() {
  const auto count = static_cast<std::size_t>(element_.count);
  part_.positions.reserve(3 * count);
  if (has_normals_) part_.normals.reserve(3 * count);
  if (has_uvs_) part_.uvs[0].reserve(2 * count);
  if (has_colors_) part_.colors.reserve(4 * count);
}

// Sends numbers to slots one after the other. Returns: whether all are there; else none is sent.
bool PlyVertices::plan_numbers(std::initializer_list<std::string_view> names, Slot first) {
  for (const std::string_view name : names)
    if (!ply_number(element_, name)) return false;
  std::size_t slot = first;
  for (const std::string_view name : names) plan_.to[*ply_number(element_, name)] = slot++;
  return true;
}

void PlyVertices::plan_colors() {
  const auto is_taken = [&](std::string_view name, std::size_t channel) {
    const auto i = ply_number(element_, name);
    if (i) color_types_[channel] = element_.properties[*i].type;
    return i && PlyColors::takes(color_types_[channel]);
  };
  // The names of most programs; those of the oldest; those of some that write scans.
  constexpr std::array<std::array<std::string_view, 4>, 3> spellings{
      {{"red", "green", "blue", "alpha"},
       {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"},
       {"r", "g", "b", "a"}}};
  for (const auto& [r, g, b, a] : spellings) {
    if (has_colors_ || !is_taken(r, 0) || !is_taken(g, 1) || !is_taken(b, 2)) continue;
    has_colors_ = plan_numbers({r, g, b}, red);
    has_alpha_ = is_taken(a, 3) && plan_numbers({a}, alpha);
  }
}

bool PlyVertices::take(const PlyRow& row, const PlyPlace& place) {
  take_position(row, place);
  if (has_normals_) take_normal(row, place);
  if (has_uvs_) take_uv(row, place);
  if (has_colors_) take_color(row, place);
  return true;
}

void PlyVertices::take_position(const PlyRow& row, const PlyPlace& place) {
  for (std::size_t i = x; i <= z; ++i)
    if (!(std::fabs(row.numbers[i]) <= most_coordinate))
      return refuse(place, row.numbers[i], "a position of numbers from -1e9 to 1e9");
  part_.positions.insert(part_.positions.end(), &row.numbers[x], &row.numbers[x] + 3);
}

void PlyVertices::take_normal(const PlyRow& row, const PlyPlace& place) {
  bool has_length = false;
  for (std::size_t i = nx; i <= nz; ++i) {
    if (!(std::fabs(row.numbers[i]) <= most_float))
      return refuse(place, row.numbers[i], "a normal of finite floats");
    part_.normals.push_back(static_cast<float>(row.numbers[i]));
    has_length = has_length || part_.normals.back() != 0;
  }
  if (!has_length && !without_length_) without_length_ = place;
}

void PlyVertices::take_uv(const PlyRow& row, const PlyPlace& place) {
  for (std::size_t i = u; i <= v; ++i)
    if (!std::isfinite(row.numbers[i]))
      return refuse(place, row.numbers[i], "texture coordinates of finite numbers");
  part_.uvs[0].insert(part_.uvs[0].end(), {row.numbers[u], 1 - row.numbers[v]});
}

void PlyVertices::take_color(const PlyRow& row, const PlyPlace& place) {
  std::array<float, 4> color{0, 0, 0, 1};
  for (std::size_t i = 0; i < (has_alpha_ ? 4 : 3); ++i) {
    const double stored = row.numbers[red + i];
    const PlyType type = color_types_[i];
    if (!is_whole(type) && !(stored >= 0 && stored <= 1))
      return refuse(place, stored, "a colour of numbers from 0 to 1");
    color[i] = i < 3 ? colors_.linear(type, stored) : PlyColors::alpha(type, stored);
  }
  part_.colors.insert(part_.colors.end(), color.begin(), color.end());
}

void PlyVertices::refuse(const PlyPlace& place, double got, const std::string& allowed) {
  faults_.add(place.fault(FaultKind::out_of_range, shown_number(got), allowed));
}

ModelPart PlyVertices::finish() {
  if (without_length_) {
    part_.normals = {};
    model_.warn({"", without_length_->line.value_or(0),
                 "normals are not used, for that of " + without_length_->name() + " is 0"});
  }
  return std::exchange(part_, {});
}

}  // namespace tia
