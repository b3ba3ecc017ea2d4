#include "core/models/ply_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "core/models/polygons.h"

namespace tia {

PlyPlan PlyFaces::plan_faces(const PlyElement& element) {
  PlyPlan plan = plan_strips(element);
  plan.most_listed = limits_.polygon_corners;
  return plan;
}

PlyPlan PlyFaces::plan_strips(const PlyElement& element) {
  PlyPlan plan(element);
  const auto wanted = std::ranges::find_if(element.properties, [](const PlyProperty& each) {
    return each.count && (each.name == "vertex_indices" || each.name == "vertex_index");
  });
  if (wanted != element.properties.end()) {
    plan.to[static_cast<std::size_t>(wanted - element.properties.begin())] = PlyPlan::list;
    warn_of_skipped(element, plan, model_);
    // The header has seen to it that the file has a byte for each row.
    corners_.reserve(3 * std::min(element.count, limits_.triangles));
  } else if (element.count > 0) {
    faults_.add(ply_fault(FaultKind::missing, element, std::nullopt,
                          "a list vertex_indices of the element " + std::string(element.name)));
  }
  return plan;
}

bool PlyFaces::take_face(const PlyRow& row, const PlyPlace& place) {
  if (row.list.size() < 3) {
    if (left_out_++ == 0) first_left_out_ = place;
    return true;
  }
  const std::size_t before = corners_.size();
  for (const double index : row.list) {
    if (!is_vertex(index, place)) {
      corners_.resize(before);
      return true;
    }
    corners_.push_back(static_cast<std::uint32_t>(index));
  }
  return add(row.list.size(), place);
}

bool PlyFaces::take_strip(const PlyRow& row, const PlyPlace& place) {
  std::array<std::uint32_t, 3> last{};
  std::size_t length = 0;
  for (const double index : row.list) {
    if (faults_.full()) return false;
    if (index == -1) {
      length = 0;
      continue;
    }
    if (!is_vertex(index, place)) return true;
    last = {last[1], last[2], static_cast<std::uint32_t>(index)};
    if (++length < 3 || last[0] == last[1] || last[1] == last[2] || last[2] == last[0]) continue;
    const bool turned = length % 2 == 0;
    corners_.insert(corners_.end(), {last[turned ? 1 : 0], last[turned ? 0 : 1], last[2]});
    if (!add(3, place)) return false;
  }
  return true;
}

bool PlyFaces::is_vertex(double index, const PlyPlace& place) {
  if (index >= 0 && index < static_cast<double>(vertices_) && std::floor(index) == index)
    return true;
  faults_.add(place.fault(FaultKind::out_of_range, shown_number(index),
                          "a vertex's number from 0, below " + std::to_string(vertices_)));
  return false;
}

// Counts a face, whose corners are the last ones. Returns: whether the model may have it.
bool PlyFaces::add(std::size_t corners, const PlyPlace& place) {
  if (corners > 3) polygons_.push_back({corners_.size() - corners, corners});
  triangles_ += corners - 2;
  if (triangles_ <= limits_.triangles) return true;
  faults_.add(
      place.fault(FaultKind::limit, std::nullopt,
                  "a model of at most " + std::to_string(limits_.triangles) + " triangles"));
  return false;
}

void PlyFaces::triangulate_into(ModelPart& part) {
  if (first_left_out_)
    model_.warn({"", first_left_out_->line.value_or(0),
                 "faces of fewer than 3 corners are left out: " + std::to_string(left_out_) +
                     ", the first of them " + first_left_out_->name()});
  if (polygons_.empty()) {
    part.indices = std::move(corners_);
    return;
  }
  part.indices.reserve(3 * static_cast<std::size_t>(triangles_));
  const auto corner = [&](std::size_t i) {
    return corners_.begin() + static_cast<std::ptrdiff_t>(i);
  };
  std::size_t done = 0;
  for (const Polygon& polygon : polygons_) {
    if (faults_.full()) return;
    part.indices.insert(part.indices.end(), corner(done), corner(polygon.first));
    done = polygon.first + polygon.count;
    triangulate({corner(polygon.first), corner(done)}, part.positions, part.indices);
  }
  part.indices.insert(part.indices.end(), corner(done), corners_.end());
}

}  // namespace tia
