// The vertices of a PLY file: rows of its element `vertex` become the lists of a part.
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "core/models/model_files.h"
#include "core/models/ply_colors.h"
#include "core/models/ply_rows.h"

namespace tia {

/// PlyVertices: positions x, y, z; normals nx, ny, nz; uvs of the first of `s t`, `u v`, `texture_u
/// texture_v`, whose v is upward there; colours red, green, blue, alpha. Normals are left out where
/// one has no length.
class PlyVertices {
 public:
  /// Errors: `missing` and `limit`, as faults at the element's line.
  PlyVertices(const PlyElement& element, const ModelLimits& limits, Faults& faults, Model& model);

  const PlyPlan& plan() const { return plan_; }
  /// Errors: `out_of_range`, as a fault. Returns: true.
  bool take(const PlyRow& row, const PlyPlace& place);
  /// All of them; warns of normals.
  ModelPart finish();

 private:
  enum Slot : std::size_t { x, y, z, nx, ny, nz, u, v, red, green, blue, alpha };

  bool plan_numbers(std::initializer_list<std::string_view> names, Slot first);
  void plan_colors();
  void reserve();
  void take_position(const PlyRow& row, const PlyPlace& place);
  void take_normal(const PlyRow& row, const PlyPlace& place);
  void take_uv(const PlyRow& row, const PlyPlace& place);
  void take_color(const PlyRow& row, const PlyPlace& place);
  void refuse(const PlyPlace& place, double got, const std::string& allowed);

  const PlyElement& element_;
  PlyPlan plan_;
  Faults& faults_;
  Model& model_;
  ModelPart part_;
  bool has_normals_ = false, has_uvs_ = false, has_colors_ = false, has_alpha_ = false;
  std::array<PlyType, 4> color_types_{};
  PlyColors colors_;
  std::optional<PlyPlace> without_length_;  // the first normal of that kind
};

}  // namespace tia
