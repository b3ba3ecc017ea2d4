#include "core/models/stl_solid.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace tia {
namespace {

bool refuse_stl(std::string allowed, std::optional<std::size_t> line, Faults& faults) {
  faults.add({FaultKind::limit, "", std::nullopt, std::move(allowed), "", std::nullopt, line});
  return false;
}

}  // namespace

bool check_stl_triangles(std::uint64_t count, const ModelLimits& limits, Faults& faults) {
  constexpr std::uint64_t most_numbered = std::numeric_limits<std::uint32_t>::max() / 3;
  const std::uint64_t most = std::min(limits.triangles, most_numbered);
  return count <= most ||
         refuse_stl("a model of at most " + std::to_string(most) + " triangles", {}, faults);
}

bool add_stl_solid(StlSolid& solid, const ModelLimits& limits, Faults& faults, Model& model) {
  if (model.nodes.size() >= limits.nodes)
    return refuse_stl("a model of at most " + std::to_string(limits.nodes) + " nodes, one a solid",
                      solid.line, faults);
  ModelMesh mesh;
  mesh.name = excerpt_of(solid.name, longest_name);
  mesh.parts.push_back(solid.vertices.take());
  ModelNode node;
  node.name = mesh.name;
  node.mesh = static_cast<ModelIndex>(model.meshes.size());
  model.scenes.front().nodes.push_back(static_cast<ModelIndex>(model.nodes.size()));
  model.meshes.push_back(std::move(mesh));
  model.nodes.push_back(std::move(node));
  return true;
}

}  // namespace tia
