#include <algorithm>
#include <cmath>

#include "core/models/gltf/gltf_attributes.h"
#include "core/models/gltf/gltf_bytes.h"
#include "core/models/gltf/gltf_skins.h"

namespace tia::gltf {
namespace {

using Matrix = std::array<double, 16>;
constexpr Matrix identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

// The last rows are 0, 0, 0, 1: what else they are bends no point.
bool all_affine(const std::vector<Matrix>& matrices) {
  constexpr double tolerance = 1e-5;
  return std::ranges::all_of(matrices, [](const Matrix& m) {
    return std::fabs(m[3]) <= tolerance && std::fabs(m[7]) <= tolerance &&
           std::fabs(m[11]) <= tolerance && std::fabs(m[15] - 1) <= tolerance;
  });
}

std::vector<Matrix> read_inverse_binds(const GltfSource& source, const GltfObject& object,
                                       std::size_t joints) {
  constexpr std::string_view name = "inverseBindMatrices";
  std::vector<Matrix> matrices(joints, identity);
  const Accessor* accessor = accessor_for(source, object, name, {only(ElementType::mat4), floats});
  if (accessor == nullptr) return matrices;
  if (accessor->count < joints || accessor->strided) {
    object.fault(FaultKind::conflict, name, Value(std::to_string(accessor->count) + " matrices"),
                 "one for each of the " + std::to_string(joints) +
                     " joints, in a view without a byteStride");
    return matrices;
  }
  const auto numbers = read_elements<double>(source, *accessor, joints, farthest);
  if (!numbers) return matrices;
  for (std::size_t i = 0; i < joints; ++i)
    std::copy_n(numbers->data() + i * 16, 16, matrices[i].data());
  if (!all_affine(matrices))
    object.fault(FaultKind::out_of_range, name, std::nullopt,
                 "affine matrices, column by column: their last rows are 0, 0, 0, 1");
  return matrices;
}

ModelSkin read_skin(const GltfSource& source, const GltfObject& object, std::size_t nodes,
                    std::uint64_t& left) {
  ModelSkin skin;
  skin.name = object.text("name");
  object.needs("joints", "the numbers of nodes");
  object.index("skeleton", nodes);
  skin.joints = object.unique_indices("joints", nodes);
  if (skin.joints.size() > left) {
    object.fault(FaultKind::limit, "joints", Value(static_cast<double>(skin.joints.size())),
                 "at most " + std::to_string(source.limits.instances) + " joints of all skins");
    return skin;
  }
  left -= skin.joints.size();
  skin.inverse_binds = read_inverse_binds(source, object, skin.joints.size());
  return skin;
}

// How many joints the vertices of a mesh name: one more than the largest number.
std::size_t joints_named(const ModelMesh& mesh) {
  std::size_t count = 0;
  for (const ModelPart& part : mesh.parts)
    for (const std::uint32_t joint : part.joints) count = std::max<std::size_t>(count, joint + 1);
  return count;
}

// A node's skin has the joints that its mesh's vertices name.
void check_skinned(const GltfSource& source, const Model& model) {
  std::vector<std::size_t> named;
  named.reserve(model.meshes.size());
  for (const ModelMesh& mesh : model.meshes) named.push_back(joints_named(mesh));
  const Place list = source.root.at().at("nodes");
  for (std::size_t i = 0; i < model.nodes.size() && !source.faults.full(); ++i) {
    const ModelNode& node = model.nodes[i];
    if (!node.skin || !node.mesh || model.meshes[*node.mesh].parts.empty()) continue;
    const std::size_t needed = named[*node.mesh], have = model.skins[*node.skin].joints.size();
    if (needed == 0)
      source.faults.add({FaultKind::conflict, list.at(i).pointer(), std::nullopt,
                         "a mesh with JOINTS_0 and WEIGHTS_0, where it has a skin"});
    else if (needed > have)
      source.faults.add({FaultKind::out_of_range, list.at(i).at("skin").pointer(),
                         Value(static_cast<double>(*node.skin)),
                         "a skin of " + std::to_string(needed) +
                             " joints or more, for so many do its mesh's vertices name"});
  }
}

}  // namespace

void read_skins(const GltfSource& source, Model& model) {
  const std::size_t nodes = source.root.size_of("nodes");
  std::uint64_t left = source.limits.instances;
  source.root.for_each("skins", [&](const GltfObject& object, std::size_t) {
    model.skins.push_back(read_skin(source, object, nodes, left));
  });
  if (source.faults.empty()) check_skinned(source, model);
}

}  // namespace tia::gltf
