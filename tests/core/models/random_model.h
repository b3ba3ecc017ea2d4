// Flat forms to test with: one with everything in it, and random ones.
#pragma once

#include "core/models/model.h"
#include "tests/core/support.h"

namespace tia::test {

/// Two nodes, two triangles, and one of everything else that a model may have.
inline Model full_model() {
  Model m;
  m.format = "gltf";
  m.generator = "a test";
  m.images = {{"picture", {1, 2, 3}}};
  m.textures = {{0, Wrap::mirrored_repeat, Wrap::clamp_to_edge, true}};
  ModelMaterial material;
  material.name = "paint";
  material.base_color_texture = TextureUse{0, 1, {0.5, 0}, {2, 1}, 0.25, 1};
  material.attenuation_distance = 3;
  m.materials = {material};
  ModelPart part;
  part.positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  part.normals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  part.tangents = {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1};
  part.uvs = {std::vector<double>{0, 0, 1, 0, 1, 1, 0, 1}, {0, 0, 1, 0, 1, 1, 0, 1}};
  part.colors.assign(16, 0.5F);
  part.joints = {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0};
  part.weights.assign(16, 0.25F);
  part.targets = {{std::vector<float>(12, 1.0F), std::vector<float>(12), {}}};
  part.indices = {0, 1, 2, 0, 2, 3};
  part.material = 0;
  part.variants = {{0, 0}};
  m.meshes = {{"sheet", {part}, {0.5}}};
  m.cameras = {{"eye", false, 0.7, 1.5, 1, 1}};
  m.lights = {{"lamp", ModelLightKind::spot, {1, 1, 1}, 100, 0.1, 0.5}};
  m.skins = {{"bones", {0, 1}, std::vector<std::array<double, 16>>(2)}};
  ModelNode root;
  root.name = "root";
  root.children = {1};
  root.mesh = root.camera = root.light = root.skin = 0;
  root.instances = {Placement{}};
  m.nodes = {root, ModelNode{}};
  m.scenes = {{"all", {0}}};
  m.animations = {
      {"wave",
       {{1, AnimatedPath::translation, Interpolation::linear, {0, 1}, {0, 0, 0, 1, 2, 3}}}}};
  m.variants = {"red"};
  m.extensions = {"KHR_texture_transform"};
  m.warnings = {{"/meshes/0", 0, "lines are left out"}};
  return m;
}

/// One of triangles without order, in a tree of nodes that are turned, moved and scaled.
inline Model random_model(Random& random) {
  Model m = full_model();
  const auto three = [&] {
    const double x = random.in(-5, 5), y = random.in(-5, 5);
    return Vec3d{x, y, random.in(-5, 5)};
  };
  const int count = random.whole(2, 12);
  for (int i = 2; i < count; ++i) {
    ModelNode node;
    node.name = "node " + std::to_string(i);
    node.placement.translation = three();
    node.placement.scale = Vec3d{random.in(0.1, 2), random.in(-2, -0.1), random.in(0.5, 3)};
    for (double& each : node.placement.rotation) each = random.in(0.1, 1);
    if (random.below(2) == 0) node.mesh = 0;
    m.nodes.push_back(node);
    m.nodes[static_cast<std::size_t>(random.below(i))].children.push_back(
        static_cast<ModelIndex>(i));
  }
  for (double& each : m.meshes[0].parts[0].positions) each = random.in(-1, 1);
  for (float& each : m.meshes[0].parts[0].weights) each = static_cast<float>(random.unit());
  return m;
}

}  // namespace tia::test
