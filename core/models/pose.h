// Where a model's nodes are at a moment.
#pragma once

#include <cstdint>
#include <vector>

#include "core/math/aabb.h"
#include "core/math/transform.h"
#include "core/models/model.h"

namespace tia {

/// ModelMoment: which of a model's scenes, and when of which animation.
struct ModelMoment {
  MaybeIndex scene;      ///< none: the model's own choice
  MaybeIndex animation;  ///< none: as the nodes stand
  double seconds = 0;
};

/// Pose. Space/units: the model's own, its up as in its file.
struct Pose {
  std::vector<ModelIndex> shown;             ///< the scene's nodes, each after its parent
  std::vector<Affine> places;                ///< of every node, from its own space to the model's
  std::vector<std::vector<double>> weights;  ///< of every node's morph targets; or none
};
/// Domain: a model that check_model has passed; numbers of its lists.
Pose pose_of(const Model& model, const ModelMoment& moment = {});

/// The map that a placement means: scaled, then turned, then moved.
Affine affine_of(const Placement& placement);
/// Where the instances of a shown node's mesh are, one at least.
std::vector<Affine> places_of(const ModelNode& node, const Affine& place);

/// PartShape: a part's vertices as they are at a moment: its morph targets added, then moved with
/// its skin's joints. Shape: x, y, z of each, of tangents w, too; no normals where the part has
/// none, or where one came to nothing. Space/units: the mesh's own; with a skin the model's.
struct PartShape {
  std::vector<double> positions, normals;
  std::vector<double> tangents{};  ///< of any length; none where the part has none
};
/// Whether a node's part has another shape than in the file: its vertices are moved one by one.
bool is_posed(const ModelNode& node, const ModelPart& part);
PartShape shape_of(const Model& model, const Pose& pose, ModelIndex node, const ModelPart& part);

/// So many vertices are placed one by one for their box, which takes a second; of those beyond a
/// box is, which may be larger: a short file may name a large mesh many times.
inline constexpr std::uint64_t most_placed_vertices = std::uint64_t{1} << 26U;
/// The box around a part's vertices in all its places, as many of them one by one as are `left`.
Aabb bounds_at(const std::vector<Affine>& places, const std::vector<double>& positions,
               std::uint64_t& left);
/// The box around all vertices that a pose shows, as bounds_at finds it; empty where it shows none.
Aabb bounds_of(const Model& model, const Pose& pose);

}  // namespace tia
