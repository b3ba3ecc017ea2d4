// What a model shows at a moment: its parts, where they are and what they wear.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/models/model_tangents.h"
#include "core/scene/model_choice.h"

namespace tia {

/// ModelBudget: how much the models of one scene may come to. A short file may name a large mesh
/// many times.
struct ModelBudget {
  std::int64_t objects =
      1 << 20;  ///< meshes, points and their colours, each as often as it is placed
  std::int64_t vertices = 1 << 26;  ///< with triangles; of lists that are shared once
  /// Takes from what is left. Returns: whether so much was.
  bool take(std::int64_t more_objects, std::int64_t more_vertices) {
    objects -= more_objects;
    vertices -= more_vertices;
    return !is_exceeded();
  }
  bool is_exceeded() const { return objects < 0 || vertices < 0; }
};

/// ModelPiece: a part of a mesh as a node shows it.
struct ModelPiece {
  std::string name;            ///< the node's, else the mesh's
  std::vector<Affine> places;  ///< in the model's space, one at least
  MaybeIndex material;
  bool points = false;
  Mesh mesh;  ///< its triangles; of points the positions and colours alone
};

/// All that is shown. Lists are shared between pieces wherever they are the same: of a part that
/// several nodes show they all are, unless its vertices are moved one by one.
/// `tangents`: those that the file does not have; null: nobody needs them.
/// Returns: none where the budget does not reach, which is then exceeded.
std::vector<ModelPiece> pieces_of(const Model& model, const ModelChoice& choice,
                                  ModelBudget& budget, ModelTangents* tangents);

/// The box around them. Space/units: the model's own.
Aabb bounds_of(const std::vector<ModelPiece>& pieces);

}  // namespace tia
