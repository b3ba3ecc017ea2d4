// Scenes of models: how tests make them without a file, and look at what they show.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/resolve_models.h"
#include "tests/core/faults.h"
#include "tests/core/support.h"

namespace tia::test {

/// A source that knows one model, by any id but "unknown".
inline ModelSource source_of(Model model) {
  auto kept = std::make_shared<const KeptModel>(
      KeptModel{std::make_shared<const Model>(std::move(model)), {}});
  return [kept](const std::string& id) { return id == "unknown" ? nullptr : kept; };
}

/// The scene with its models resolved. Domain: of one without a fault.
inline Scene resolved(Scene scene, const Model& model) {
  Faults faults;
  resolve_models(scene, source_of(model), faults);
  for (const Fault& fault : faults.list()) ADD_FAILURE() << describe(fault);
  return scene;
}
/// Of a scene that is one model with these members: R"("up":"z")".
inline std::string model_scene(const std::string& members = "") {
  return R"({"objects":[{"type":"model","id":"it")" + (members.empty() ? "" : "," + members) +
         "}]}";
}
/// What that shows.
inline std::vector<Object> shown_by(const Model& model, const std::string& members = "") {
  return *children_of(resolved(read_scene(model_scene(members)), model).objects[0]);
}
/// The faults of resolving it.
inline std::vector<Fault> model_faults(const Model& model, const std::string& json,
                                       const ModelBudget& most = {}) {
  Scene scene = read_scene(json);
  Faults faults;
  resolve_models(scene, source_of(model), faults, most);
  return faults.list();
}

inline const Mesh& mesh_in(const Object& object) { return std::get<Mesh>(object.shape); }

/// Where an object's vertices are, one after the other.
inline std::vector<Vec3d> placed_vertices(const Object& object) {
  const Affine map = object.transform.affine();
  const std::vector<double>& p = mesh_in(object).positions.values;
  std::vector<Vec3d> all;
  for (std::size_t i = 0; i + 2 < p.size(); i += 3)
    all.push_back(map.point(Vec3d{p[i], p[i + 1], p[i + 2]}));
  return all;
}
inline void expect_near_points(const std::vector<Vec3d>& got, const std::vector<Vec3d>& expected,
                               double most) {
  ASSERT_EQ(got.size(), expected.size());
  for (std::size_t i = 0; i < got.size(); ++i)
    EXPECT_LE(length(got[i] - expected[i]), most)
        << testing::PrintToString(got[i]) << " expected " << testing::PrintToString(expected[i]);
}

/// One triangle with corners at 0, x and y, of lengths 4 and 2, in a node; its material is "paint".
inline Model triangle_model() {
  Model model;
  model.format = "gltf";
  ModelPart part;
  part.positions = {0, 0, 0, 4, 0, 0, 0, 2, 0};
  part.indices = {0, 1, 2};
  part.material = 0;
  ModelMaterial paint;
  paint.name = "paint";
  paint.base_color = {0.1, 0.5, 0.9};
  model.materials = {paint};
  model.meshes = {{"sheet", {part}, {}}};
  ModelNode node;
  node.name = "root";
  node.mesh = 0;
  model.nodes = {node};
  model.scenes = {{"all", {0}}};
  return model;
}
inline const std::vector<Vec3d> triangle_corners{{0, 0, 0}, {4, 0, 0}, {0, 2, 0}};

}  // namespace tia::test
