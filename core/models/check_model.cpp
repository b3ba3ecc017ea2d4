#include "core/models/check_model.h"

#include <algorithm>
#include <cmath>

#include "core/models/check_parts.h"

namespace tia {
namespace {

// ---- lists that name each other -----------------------------------------------------------------

class ModelChecker {
 public:
  ModelChecker(const Model& model, const ModelLimits& limits, Faults& faults)
      : model_(model), limits_(limits), faults_(faults) {}

  void check() {
    if (model_.scenes.empty()) fault(root_.at("scenes"), "no scene", "at least one");
    else check_index(model_.scene, model_.scenes.size(), root_.at("scene"));
    check_materials();
    check_meshes();
    check_nodes();
    check_scenes();
    check_motion();
  }

 private:
  void fault(const Place& at, std::string got, std::string allowed,
             FaultKind kind = FaultKind::out_of_range) {
    faults_.add({kind, at.pointer(), Value(std::move(got)), std::move(allowed)});
  }
  bool check_index(std::uint64_t index, std::size_t size, const Place& at) {
    if (index < size) return true;
    fault(at, std::to_string(index), "a number below " + std::to_string(size));
    return false;
  }
  void check_index(const MaybeIndex& index, std::size_t size, const Place& at) {
    if (index) check_index(*index, size, at);
  }
  void check_most(std::uint64_t count, std::uint64_t most, const char* what, const Place& at) {
    if (count > most)
      fault(at, std::to_string(count) + " " + what, "at most " + std::to_string(most),
            FaultKind::limit);
  }
  template <class List, class F>
  void for_each(const List& list, const Place& at, F f) {
    for (std::size_t i = 0; i < list.size() && !faults_.full(); ++i) f(list[i], at.at(i));
  }

  void check_materials() {
    for_each(model_.textures, root_.at("textures"), [&](const ModelTexture& each, const Place& at) {
      check_index(each.image, model_.images.size(), at.at("image"));
      if (each.wrap_u > Wrap::clamp_to_edge || each.wrap_v > Wrap::clamp_to_edge)
        fault(at, "a wrap", "repeat, mirrored_repeat or clamp_to_edge");
    });
    for_each(model_.materials, root_.at("materials"),
             [&](const ModelMaterial& each, const Place& at) {
               check_material(each, model_.textures.size(), at, faults_);
             });
    for_each(model_.cameras, root_.at("cameras"),
             [&](const ModelCamera& each, const Place& at) { check_camera(each, at, faults_); });
    for_each(model_.lights, root_.at("lights"),
             [&](const ModelLight& each, const Place& at) { check_light(each, at, faults_); });
  }

  void check_meshes() {
    std::uint64_t triangles = 0, vertices = 0;
    for_each(model_.meshes, root_.at("meshes"), [&](const ModelMesh& mesh, const Place& at) {
      for_each(mesh.parts, at.at("parts"), [&](const ModelPart& part, const Place& own) {
        triangles += part.triangles();
        vertices += part.vertices();
        check_part(part, own, faults_);
        check_index(part.material, model_.materials.size(), own.at("material"));
        if (part.targets.size() != mesh.parts.front().targets.size())
          fault(own.at("targets"), std::to_string(part.targets.size()),
                "as many as its mesh's first part has");
        for_each(part.variants, own.at("variants"),
                 [&](const VariantMaterial& each, const Place& place) {
                   check_index(each.variant, model_.variants.size(), place.at("variant"));
                   check_index(each.material, model_.materials.size(), place.at("material"));
                 });
      });
      check_weights(mesh.weights, mesh, at.at("weights"));
    });
    check_most(triangles, limits_.triangles, "triangles", root_.at("meshes"));
    check_most(vertices, limits_.vertices, "vertices", root_.at("meshes"));
  }
  void check_weights(const std::vector<double>& weights, const ModelMesh& mesh, const Place& at) {
    check_finite(weights, at, faults_);
    const std::size_t targets = mesh.parts.empty() ? 0 : mesh.parts.front().targets.size();
    if (!weights.empty() && weights.size() != targets)
      fault(at, std::to_string(weights.size()) + " weights",
            "one for each of " + std::to_string(targets) + " targets, or none");
  }

  void check_nodes() {
    const std::vector<ModelNode>& nodes = model_.nodes;
    check_most(nodes.size(), limits_.nodes, "nodes", root_.at("nodes"));
    std::uint64_t instances = 0;
    parents_.assign(nodes.size(), none);
    for_each(nodes, root_.at("nodes"), [&](const ModelNode& node, const Place& at) {
      check_placement(node, at, faults_);
      check_index(node.mesh, model_.meshes.size(), at.at("mesh"));
      check_index(node.camera, model_.cameras.size(), at.at("camera"));
      check_index(node.light, model_.lights.size(), at.at("light"));
      check_index(node.skin, model_.skins.size(), at.at("skin"));
      instances += node.instances.size();
      for_each(node.children, at.at("children"),
               [&](ModelIndex child, const Place& own) { adopt(child, at.index, own); });
      if (faults_.empty() && node.mesh) check_weights(node.weights, model_.meshes[*node.mesh], at);
      if (faults_.empty() && node.mesh && node.skin)
        check_joints(model_.meshes[*node.mesh], model_.skins[*node.skin].joints.size(), at);
    });
    check_most(instances, limits_.instances, "instances", root_.at("nodes"));
    if (faults_.empty()) check_tree();
  }
  void adopt(ModelIndex child, std::size_t parent, const Place& at) {
    if (!check_index(child, parents_.size(), at)) return;
    if (parents_[child] != none)
      fault(at, std::to_string(child), "a node that is nobody else's child", FaultKind::conflict);
    parents_[child] = parent;
  }
  void check_joints(const ModelMesh& mesh, std::size_t joints, const Place& at) {
    for (const ModelPart& part : mesh.parts) {
      const auto greatest = std::ranges::max_element(part.joints);
      if (greatest != part.joints.end()) check_index(*greatest, joints, at.at("skin"));
    }
  }
  // Each node's depth, found once: a circle never comes to a root.
  void check_tree() {
    std::vector<std::uint32_t> depths(parents_.size(), 0);
    std::vector<std::size_t> path;
    for (std::size_t start = 0; start < parents_.size() && !faults_.full(); ++start) {
      path.clear();
      std::size_t node = start;
      for (; node != none && depths[node] == 0 && path.size() <= limits_.depth;
           node = parents_[node])
        path.push_back(node);
      std::uint32_t depth = node == none ? 0 : depths[node];
      for (auto each = path.rbegin(); each != path.rend(); ++each) depths[*each] = ++depth;
      if (depth > limits_.depth || path.size() > limits_.depth)
        return fault(root_.at("nodes").at(start), "a node within too many, or within itself",
                     "at most " + std::to_string(limits_.depth) + " nodes above each other",
                     FaultKind::limit);
    }
  }
  void check_scenes() {
    for_each(model_.scenes, root_.at("scenes"), [&](const ModelScene& scene, const Place& at) {
      for_each(scene.nodes, at.at("nodes"), [&](ModelIndex node, const Place& own) {
        if (check_index(node, parents_.size(), own) && parents_[node] != none)
          fault(own, std::to_string(node), "a node that is nobody's child", FaultKind::conflict);
      });
    });
  }

  void check_motion() {
    for_each(model_.skins, root_.at("skins"), [&](const ModelSkin& skin, const Place& at) {
      for_each(skin.joints, at.at("joints"), [&](ModelIndex joint, const Place& own) {
        check_index(joint, model_.nodes.size(), own);
      });
      if (skin.inverse_binds.size() != skin.joints.size())
        fault(at.at("inverse_binds"), std::to_string(skin.inverse_binds.size()), "one a joint");
      for (const auto& each : skin.inverse_binds) check_finite(each, at, faults_);
    });
    for_each(model_.animations, root_.at("animations"),
             [&](const ModelAnimation& own, const Place& at) {
               for_each(own.channels, at.at("channels"),
                        [&](const AnimationChannel& each, const Place& place) {
                          if (check_index(each.node, model_.nodes.size(), place.at("node")))
                            check_channel(each, targets_of(each.node), place, faults_);
                        });
             });
  }
  std::size_t targets_of(ModelIndex number) const {
    const MaybeIndex mesh = model_.nodes[number].mesh;
    if (!mesh || *mesh >= model_.meshes.size() || model_.meshes[*mesh].parts.empty()) return 0;
    return model_.meshes[*mesh].parts.front().targets.size();
  }

  static constexpr std::size_t none = ~std::size_t{0};
  const Model& model_;
  const ModelLimits& limits_;
  Faults& faults_;
  const Place root_;
  std::vector<std::size_t> parents_;  // of each node, or none
};

}  // namespace

void check_model(const Model& model, const ModelLimits& limits, Faults& faults) {
  ModelChecker(model, limits, faults).check();
}

}  // namespace tia
