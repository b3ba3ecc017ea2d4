// What an OBJ file says, as it says it: lists of numbers, and corners that name them. No triangle
// and no vertex is made yet.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/models/obj_corner.h"

namespace tia {

/// ObjRun: faces or points that follow each other in one mesh with one material.
struct ObjRun {
  std::uint32_t mesh = 0, material = 0;  ///< of the content's lists
  std::size_t first = 0, count = 0;      ///< elements
  std::size_t first_corner = 0, corners = 0;
};

/// ObjCorners: a list of corners. What none of them names takes no room.
class ObjCorners {
 public:
  std::size_t size() const { return positions_.size(); }
  ObjCorner operator[](std::size_t i) const {
    return {positions_[i], at(uvs_, i), at(normals_, i)};
  }
  void push_back(const ObjCorner& corner) {
    add(corner.uv, uvs_), add(corner.normal, normals_);
    positions_.push_back(corner.position);
  }
  /// Calls f(list) for its lists of numbers; those that are empty take no room.
  template <class F>
  void for_each_list(F f) {
    for (Indices* list : {&positions_, &uvs_, &normals_})
      if (!list->empty()) f(*list);
  }
  /// Drops all behind the first ones. Domain: at most size().
  void shrink(std::size_t size) {
    for_each_list([size](Indices& list) { list.resize(size); });
  }

 private:
  using Indices = std::vector<std::uint32_t>;
  static std::uint32_t at(const Indices& list, std::size_t i) {
    return list.empty() ? ObjCorner::none : list[i];
  }
  // The first that is named comes after all those that are not.
  void add(std::uint32_t index, Indices& list) const {
    if (list.empty() && index == ObjCorner::none) return;
    if (list.empty()) list.assign(size(), ObjCorner::none);
    list.push_back(index);
  }

  Indices positions_, uvs_, normals_;
};

/// ObjElements: faces, or points, of one corner each.
struct ObjElements {
  ObjCorners corners;
  std::vector<std::uint32_t> sizes;  ///< corners of each element
  std::vector<ObjRun> runs;
};

/// ObjMaterialUse: a name after `usemtl`, and where it came first.
struct ObjMaterialUse {
  std::string name;
  std::size_t line = 0;
};

/// ObjContent. Colours are there for all positions or none; a position without one has NaN.
struct ObjContent {
  std::vector<double> positions, uvs;  ///< three and two numbers each; v downward
  std::vector<float> colors;           ///< linear r, g, b
  std::vector<float> normals;          ///< three numbers each
  bool has_zero_normals = false;
  std::vector<std::string> meshes;                 ///< names
  std::vector<ObjMaterialUse> materials{{"", 0}};  ///< the first one: none
  ObjElements faces, points;
  bool lacks_library = false;  ///< a file of materials did not come

  bool has_color(std::uint32_t position) const {
    return !colors.empty() && !std::isnan(colors[std::size_t{3} * position]);
  }
  bool has_normal(std::uint32_t normal) const {
    if (normal == ObjCorner::none) return false;
    const float* n = &normals[std::size_t{3} * normal];
    return !has_zero_normals || n[0] != 0 || n[1] != 0 || n[2] != 0;
  }
};

}  // namespace tia
