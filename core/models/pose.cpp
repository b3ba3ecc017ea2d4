#include "core/models/pose.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/math/quaternion.h"
#include "core/models/animation.h"

namespace tia {
namespace {

Affine affine_of(const std::array<double, 16>& columns) {
  const auto column = [&](std::size_t i) -> Vec3d {
    return {columns[4 * i], columns[4 * i + 1], columns[4 * i + 2]};
  };
  return {column(0), column(1), column(2), column(3)};
}

// A node's own numbers, which channels replace.
struct Posture {
  Placement placement;
  bool by_matrix = false;
  std::vector<double> weights;

  void take(const AnimationChannel& channel, double seconds) {
    std::vector<double> numbers = sampled(channel, seconds);
    if (channel.path == AnimatedPath::weights) {
      weights = std::move(numbers);
      return;
    }
    by_matrix = false;  // a node that is animated has no matrix
    const Vec3d three{numbers[0], numbers[1], numbers[2]};
    if (channel.path == AnimatedPath::translation) placement.translation = three;
    else if (channel.path == AnimatedPath::scale) placement.scale = three;
    else placement.rotation = {numbers[0], numbers[1], numbers[2], numbers[3]};
  }
};

std::vector<Posture> postures_of(const Model& model, const ModelMoment& moment) {
  std::vector<Posture> all;
  all.reserve(model.nodes.size());
  for (const ModelNode& node : model.nodes) {
    Posture own{node.placement, node.matrix.has_value(), node.weights};
    if (own.weights.empty() && node.mesh) own.weights = model.meshes[*node.mesh].weights;
    all.push_back(std::move(own));
  }
  if (moment.animation)
    for (const AnimationChannel& each : model.animations[*moment.animation].channels)
      all[each.node].take(each, moment.seconds);
  return all;
}

// Places a tree below a node of a given place, without recursion. `visited` is told each node.
template <class F>
void place_below(const Model& model, ModelIndex root, const std::vector<Posture>& postures,
                 std::vector<Affine>& places, F visited) {
  std::vector<std::pair<ModelIndex, Affine>> left{{root, Affine{}}};
  while (!left.empty()) {
    const auto [number, above] = left.back();
    left.pop_back();
    const ModelNode& node = model.nodes[number];
    const Posture& own = postures[number];
    places[number] = above * (own.by_matrix ? affine_of(*node.matrix) : affine_of(own.placement));
    visited(number);
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
      left.emplace_back(*child, places[number]);
  }
}

// ---- vertices -----------------------------------------------------------------------------------

void add(std::vector<double>& to, const std::vector<float>& what, double weight) {
  if (weight == 0 || to.size() != what.size()) return;
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += weight * what[i];
}

// A target's tangents have no w.
void add_tangents(std::vector<double>& to, const std::vector<float>& what, double weight) {
  if (weight == 0 || 3 * to.size() != 4 * what.size()) return;
  for (std::size_t i = 0; i < what.size(); ++i) to[i / 3 * 4 + i % 3] += weight * what[i];
}

Vec3d three_at(const std::vector<double>& list, std::size_t i) {
  return {list[3 * i], list[3 * i + 1], list[3 * i + 2]};
}
void put(std::vector<double>& list, std::size_t i, const Vec3d& v) {
  list[3 * i] = v.x;
  list[3 * i + 1] = v.y;
  list[3 * i + 2] = v.z;
}

// The sum of maps, each by its weight.
Affine blend(const std::vector<Affine>& joints, const ModelPart& part, std::size_t vertex) {
  const std::size_t each = part.joints.size() / part.vertices(), first = vertex * each;
  double sum = 0;
  for (std::size_t i = first; i < first + each; ++i) sum += part.weights[i];
  if (!(sum > 0)) return joints[part.joints[first]];
  Affine all{{}, {}, {}, {}};
  for (std::size_t i = first; i < first + each; ++i) {
    const double weight = part.weights[i] / sum;
    const Affine& joint = joints[part.joints[i]];
    all.x = all.x + joint.x * weight;
    all.y = all.y + joint.y * weight;
    all.z = all.z + joint.z * weight;
    all.offset = all.offset + joint.offset * weight;
  }
  return all;
}

// The inverse transpose up to its scale, which has no inverse to find: n -> cofactors n.
Vec3d normal_by(const Affine& map, const Vec3d& n) {
  const double side = map.determinant() < 0 ? -1 : 1;
  return (cross(map.y, map.z) * n.x + cross(map.z, map.x) * n.y + cross(map.x, map.y) * n.z) * side;
}

void move_with_skin(const Pose& pose, const ModelSkin& skin, const ModelPart& part,
                    PartShape& shape) {
  if (part.joints.empty()) return;
  std::vector<Affine> joints;
  for (std::size_t i = 0; i < skin.joints.size(); ++i)
    joints.push_back(pose.places[skin.joints[i]] * affine_of(skin.inverse_binds[i]));
  for (std::size_t i = 0; i < part.vertices(); ++i) {
    const Affine map = blend(joints, part, i);
    put(shape.positions, i, map.point(three_at(shape.positions, i)));
    if (!shape.normals.empty()) put(shape.normals, i, normal_by(map, three_at(shape.normals, i)));
    if (shape.tangents.empty()) continue;
    double* tangent = &shape.tangents[4 * i];
    const Vec3d moved = map.vector(Vec3d{tangent[0], tangent[1], tangent[2]});
    tangent[0] = moved.x, tangent[1] = moved.y, tangent[2] = moved.z;
  }
}

bool has_nothing(const std::vector<double>& normals) {
  for (std::size_t i = 0; i + 2 < normals.size(); i += 3) {
    const double squared =
        normals[i] * normals[i] + normals[i + 1] * normals[i + 1] + normals[i + 2] * normals[i + 2];
    if (!(squared > 0) || !std::isfinite(squared)) return true;
  }
  return false;
}

// The box around vertices that a map places.
Aabb box_around(const Affine& place, const std::vector<double>& positions) {
  Aabb box;
  for (std::size_t i = 0; i < positions.size() / 3; ++i)
    box = around(box, place.point(three_at(positions, i)));
  return box;
}

}  // namespace

Affine affine_of(const Placement& own) {
  const Affine turned = rotation_of(own.rotation);
  return {turned.x * own.scale.x, turned.y * own.scale.y, turned.z * own.scale.z, own.translation};
}

std::vector<Affine> places_of(const ModelNode& node, const Affine& place) {
  if (node.instances.empty()) return {place};
  std::vector<Affine> all;
  for (const Placement& each : node.instances) all.push_back(place * affine_of(each));
  return all;
}

Pose pose_of(const Model& model, const ModelMoment& moment) {
  std::vector<Posture> postures = postures_of(model, moment);
  Pose pose;
  pose.places.resize(model.nodes.size());
  std::vector<bool> is_child(model.nodes.size()), is_root(model.nodes.size());
  for (const ModelNode& node : model.nodes)
    for (const ModelIndex child : node.children) is_child[child] = true;
  for (const ModelIndex root : model.scenes[moment.scene.value_or(model.scene)].nodes) {
    is_root[root] = true;
    place_below(model, root, postures, pose.places,
                [&](ModelIndex node) { pose.shown.push_back(node); });
  }
  // Joints may stand in no scene.
  for (ModelIndex i = 0; i < model.nodes.size(); ++i)
    if (!is_child[i] && !is_root[i])
      place_below(model, i, postures, pose.places, [](ModelIndex) {});
  for (Posture& each : postures) pose.weights.push_back(std::move(each.weights));
  return pose;
}

bool is_posed(const ModelNode& node, const ModelPart& part) {
  return !part.targets.empty() || (node.skin && !part.joints.empty());
}

PartShape shape_of(const Model& model, const Pose& pose, ModelIndex number, const ModelPart& part) {
  PartShape shape{part.positions,
                  {part.normals.begin(), part.normals.end()},
                  {part.tangents.begin(), part.tangents.end()}};
  const std::vector<double>& weights = pose.weights[number];
  for (std::size_t i = 0; i < std::min(weights.size(), part.targets.size()); ++i) {
    add(shape.positions, part.targets[i].positions, weights[i]);
    add(shape.normals, part.targets[i].normals, weights[i]);
    add_tangents(shape.tangents, part.targets[i].tangents, weights[i]);
  }
  if (const MaybeIndex skin = model.nodes[number].skin)
    move_with_skin(pose, model.skins[*skin], part, shape);
  if (has_nothing(shape.normals)) shape.normals.clear();
  return shape;
}

Aabb bounds_at(const std::vector<Affine>& places, const std::vector<double>& positions,
               std::uint64_t& left) {
  const std::size_t vertices = positions.size() / 3;
  Aabb box;
  std::optional<Aabb> own;  // around the vertices as they are, once it is asked for
  for (const Affine& place : places) {
    if (left >= vertices) {
      left -= vertices;
      box = around(box, box_around(place, positions));
    } else {
      if (!own) own = box_around({}, positions);
      box = around(box, bounds_of(place, *own));
    }
  }
  return box;
}

Aabb bounds_of(const Model& model, const Pose& pose) {
  Aabb box;
  std::uint64_t left = most_placed_vertices;
  for (const ModelIndex number : pose.shown) {
    const ModelNode& node = model.nodes[number];
    if (!node.mesh) continue;
    const std::vector<Affine> places =
        node.skin ? std::vector<Affine>{{}} : places_of(node, pose.places[number]);
    for (const ModelPart& part : model.meshes[*node.mesh].parts)
      box = around(box, is_posed(node, part)
                            ? bounds_at(places, shape_of(model, pose, number, part).positions, left)
                            : bounds_at(places, part.positions, left));
  }
  return box;
}

}  // namespace tia
