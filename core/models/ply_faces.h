// The faces of a PLY file: rows of its elements `face` and `tristrips` become triangles.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/models/model_files.h"
#include "core/models/ply_rows.h"

namespace tia {

/// PlyFaces: polygons, kept until all vertices are known, for faces may stand before these.
class PlyFaces {
 public:
  /// The number of vertices that the header tells.
  PlyFaces(std::uint64_t vertices, const ModelLimits& limits, Faults& faults, Model& model)
      : vertices_(vertices), limits_(limits), faults_(faults), model_(model) {}

  /// What is wanted of an element's rows: its list vertex_indices or vertex_index, of polygons with
  /// limits.polygon_corners at most. Errors: `missing`, as a fault at the element's line.
  PlyPlan plan_faces(const PlyElement& element);
  PlyPlan plan_strips(const PlyElement& element);
  /// A polygon; of fewer than three corners it is left out.
  /// Errors: `out_of_range` and `limit`, as faults. Returns: false beyond the limit.
  bool take_face(const PlyRow& row, const PlyPlace& place);
  /// A strip: each corner makes a triangle with the two before, of which every second turns the
  /// other way; -1 starts anew. What has two equal corners is left out. Errors: as of faces.
  bool take_strip(const PlyRow& row, const PlyPlace& place);
  /// Appends the triangles; warns of faces that were left out.
  void triangulate_into(ModelPart& part);

 private:
  // A face of more than three corners: which are its.
  struct Polygon {
    std::size_t first, count;
  };
  bool is_vertex(double index, const PlyPlace& place);
  bool add(std::size_t corners, const PlyPlace& place);

  std::uint64_t vertices_;
  const ModelLimits& limits_;
  Faults& faults_;
  Model& model_;
  std::vector<std::uint32_t> corners_;  // of all faces, one after the other
  std::vector<Polygon> polygons_;
  std::uint64_t triangles_ = 0, left_out_ = 0;
  std::optional<PlyPlace> first_left_out_;
};

}  // namespace tia
