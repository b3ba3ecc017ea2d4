#include <cmath>

#include "core/models/gltf/gltf_instances.h"
#include "core/models/gltf/gltf_parts.h"
#include "core/models/gltf/gltf_tree.h"

namespace tia::gltf {
namespace {

constexpr Range placed_range{-1e9, 1e9};

/// NodeReader: reads one node after the other.
class NodeReader {
 public:
  NodeReader(const GltfSource& source, Model& model)
      : source_(source),
        model_(model),
        nodes_(source.root.size_of("nodes")),
        meshes_(source.root.size_of("meshes")),
        cameras_(source.root.size_of("cameras")),
        skins_(source.root.size_of("skins")),
        instances_left_(source.limits.instances) {
    source.root.with_extension("KHR_lights_punctual", [&](const GltfObject& extension) {
      lights_ = extension.size_of("lights");
    });
  }

  void read(const GltfObject& object) {
    ModelNode node;
    node.name = object.text("name");
    node.children = object.unique_indices("children", nodes_);
    read_placement(object, node.placement);
    if (object.has("matrix")) read_matrix(object, node);
    node.mesh = object.index("mesh", meshes_);
    node.camera = object.index("camera", cameras_);
    node.skin = object.index("skin", skins_);
    object.with_extension("KHR_lights_punctual", [&](const GltfObject& extension) {
      extension.needs("light", "the number of a light");
      node.light = extension.index("light", lights_);
    });
    read_mesh_words(object, node);
    node.instances = read_instances(source_, object, instances_left_);
    model_.nodes.push_back(std::move(node));
  }

 private:
  void warn(const GltfObject& object, std::string_view name, std::string text) {
    model_.warn({object.at().at(name).pointer(), 0, std::move(text)});
  }

  // The matrix has to leave parallels parallel, or there is no place that it means.
  void read_matrix(const GltfObject& object, ModelNode& node) {
    for (const auto name : {"translation", "rotation", "scale"})
      if (object.has(name))
        return object.fault(FaultKind::conflict, "matrix", std::nullopt,
                            "a matrix, or translation, rotation and scale");
    node.matrix = object.numbers<16>("matrix", placed_range);
    if (!node.matrix) return;
    const std::array<double, 16>& m = *node.matrix;
    constexpr double tolerance = 1e-5;
    if (std::fabs(m[3]) > tolerance || std::fabs(m[7]) > tolerance ||
        std::fabs(m[11]) > tolerance || std::fabs(m[15] - 1) > tolerance)
      object.fault(FaultKind::out_of_range, "matrix", excerpt(*object.member("matrix")),
                   "an affine matrix, column by column: its last row is 0, 0, 0, 1");
    const Vec3d x{m[0], m[1], m[2]}, y{m[4], m[5], m[6]}, z{m[8], m[9], m[10]};
    if (dot(cross(x, y), z) == 0) warn(object, "matrix", "what it holds has no volume");
  }

  void read_placement(const GltfObject& object, Placement& placement) {
    if (const auto moved = object.numbers<3>("translation", placed_range))
      placement.translation = {(*moved)[0], (*moved)[1], (*moved)[2]};
    if (const auto turned = object.numbers<4>("rotation", placed_range)) {
      placement.rotation = *turned;
      check_rotation(object, *turned);
    }
    if (const auto scaled = object.numbers<3>("scale", placed_range)) {
      placement.scale = {(*scaled)[0], (*scaled)[1], (*scaled)[2]};
      for (const double scale : *scaled)
        if (scale == 0) return warn(object, "scale", "what it holds has no volume");
    }
  }

  void check_rotation(const GltfObject& object, const std::array<double, 4>& q) {
    const double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    constexpr double tolerance = 1e-4;
    if (!(square > 0))
      object.fault(FaultKind::out_of_range, "rotation", excerpt(*object.member("rotation")),
                   "a quaternion of length 1");
    else if (std::fabs(square - 1) > tolerance)
      warn(object, "rotation", "its length is not 1: it is taken for the one that is");
  }

  // Only what has a mesh can be bent. Meshes that are not as they should be have faults already.
  void read_mesh_words(const GltfObject& object, ModelNode& node) {
    node.weights = object.number_list("weights");
    if (!object.has("mesh")) {
      for (const auto name : {"weights", "skin"})
        if (object.has(name))
          object.fault(FaultKind::conflict, name, std::nullopt, "a node that has a mesh");
      return;
    }
    if (!node.mesh || *node.mesh >= model_.meshes.size()) return;
    const std::size_t targets = model_.meshes[*node.mesh].weights.size();
    if (!node.weights.empty() && node.weights.size() != targets)
      object.fault(FaultKind::conflict, "weights",
                   Value(std::to_string(node.weights.size()) + " weights"),
                   "as many as its mesh has morph targets: " + std::to_string(targets));
  }

  const GltfSource& source_;
  Model& model_;
  std::size_t nodes_, meshes_, cameras_, skins_, lights_ = 0;
  std::uint64_t instances_left_;
};

void read_scene(const GltfObject& object, const std::vector<bool>& is_root, Model& model) {
  ModelScene scene;
  scene.name = object.text("name");
  scene.nodes = object.unique_indices("nodes", is_root.size());
  const Place list = object.at().at("nodes");
  for (std::size_t i = 0; i < scene.nodes.size() && !object.faults().full(); ++i)
    if (!is_root[scene.nodes[i]])
      object.faults().add({FaultKind::conflict, list.at(i).pointer(),
                           Value(static_cast<double>(scene.nodes[i])),
                           "nodes that are no other node's children"});
  model.scenes.push_back(std::move(scene));
}

// Without scenes everything is shown.
void read_scenes(const GltfSource& source, std::vector<ModelIndex> roots, Model& model) {
  if (!source.root.has("scenes")) {
    if (source.root.has("scene")) source.root.index("scene", 0);
    model.scenes.push_back({"", std::move(roots)});
    return;
  }
  std::vector<bool> is_root(model.nodes.size());
  for (const ModelIndex root : roots) is_root[root] = true;
  source.root.for_each(
      "scenes", [&](const GltfObject& object, std::size_t) { read_scene(object, is_root, model); });
  model.scene = source.root.index("scene", source.root.size_of("scenes")).value_or(0);
}

}  // namespace

void read_nodes(const GltfSource& source, Model& model) {
  const std::size_t count = source.root.size_of("nodes");
  if (count > source.limits.nodes) {
    source.root.fault(FaultKind::limit, "nodes", Value(static_cast<double>(count)),
                      "at most " + std::to_string(source.limits.nodes) + " nodes");
    return;
  }
  model.nodes.reserve(count);
  NodeReader reader(source, model);
  source.root.for_each("nodes",
                       [&](const GltfObject& object, std::size_t) { reader.read(object); });
  if (model.nodes.size() == count) read_scenes(source, check_tree(source, model.nodes), model);
}

}  // namespace tia::gltf
