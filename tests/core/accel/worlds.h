// Random worlds of all kinds of things, the same worlds without their indices, and rays that look
// for trouble in them.
#pragma once

#include <numeric>

#include "core/accel/world/trace.h"
#include "tests/core/random_scene.h"

namespace tia::test {

inline Object object_of(const Shape& shape, const TransformSteps& transform = {}) {
  return {"", shape, transform, {}};
}

inline World world_of(const std::vector<Object>& objects) {
  Scene scene;
  scene.objects = objects;
  return compile(scene);
}

inline TransformSteps random_placement(Random& random, double scale) {
  TransformSteps placement;
  const int steps = random.below(4);
  for (int i = 0; i < steps; ++i) {
    const int kind = random.below(4);
    if (kind == 0) placement.steps.push_back(Translate{random.point(2) * scale});
    if (kind == 1) placement.steps.push_back(RotateDegrees{random.point(180)});
    if (kind == 2) placement.steps.push_back(Scale{random.chance(0.5) ? random.in(0.5, 2) : -0.7});
    if (kind == 3) {
      const double x = random.in(0.5, 2), y = random.in(-2, -0.5);
      placement.steps.push_back(Scale{Vec3d{x, y, random.in(0.5, 2)}});
    }
  }
  return placement;
}

/// A pyramid of four corners with random normals and uvs or none.
inline Mesh random_mesh(Random& random, const Vec3d& center, double size) {
  Mesh mesh;
  for (int i = 0; i < 4; ++i) {
    const Vec3d p = center + random.direction() * size, n = random.direction();
    mesh.positions.values.insert(mesh.positions.values.end(), {p.x, p.y, p.z});
    mesh.normals.values.insert(mesh.normals.values.end(), {n.x, n.y, n.z});
  }
  if (random.chance(0.5)) mesh.normals.values.clear();
  mesh.indices.values = {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0};
  return mesh;
}

/// A solid of a size of about `size`, not a composite.
inline Shape random_solid(Random& random, const Vec3d& center, double size) {
  const Vec3d way = random.direction() * size;
  switch (random.below(6)) {
    case 0: return Box{lower(center, center + way), upper(center, center + way)};
    case 1: return Cylinder{center, center + way, random.in(0.1, 1) * size};
    case 2: return Cone{center, center + way, random.in(0.1, 1) * size, random.below(2) * size};
    case 3: return Torus{size, random.in(0.1, 0.9) * size};
    case 4: {
      const double k = 1 / (size * size);
      Bounds bounds;
      bounds.center = Vec3d{};
      bounds.radius = 2 * size;
      return Quadric{{k, 2 * k, -k, 0.3 * k, 0, 0, 0, 0, 0, -0.5}, bounds};
    }
    default: return Sphere{center, random.in(0.2, 1) * size};
  }
}

/// One thing of any kind, within a few `scale` of the origin; `depth`: of composites.
inline Object random_object(Random& random, double scale, int depth = 2) {
  const Vec3d center = random.point(10) * scale;
  const double size = random.in(0.1, 1.5) * scale;
  Object object = object_of(Sphere{center, size}, random_placement(random, scale));
  const int kind = random.below(depth > 0 ? 14 : 10);
  if (kind < 6) object.shape = random_solid(random, center, size);
  if (kind == 6) object.shape = Disc{center, random.direction(), size};
  if (kind == 7) {
    const Vec3d a = center + random.direction() * size, b = center + random.direction() * size;
    object.shape = Triangle{a, b, center};
  }
  if (kind == 8) object.shape = random_mesh(random, center, size);
  if (kind < 10) return object;
  if (kind < 12) {
    Csg csg{static_cast<Operation>(random.below(3)), {}};
    for (int i = 2 + random.below(2); i > 0; --i)
      csg.children.push_back(object_of(random_solid(random, center, 2 * size)));
    object.shape = csg;
    return object;
  }
  Group group;
  for (int i = 1 + random.below(3); i > 0; --i)
    group.children.push_back(random_object(random, scale, depth - 1));
  if (kind == 13) {
    const auto step = [&] { return random.in(0.5, 3) * scale * (random.chance(0.5) ? 1 : -1); };
    const double x = step(), y = step();
    group.repeat =
        Repeat{{1 + random.below(3), 1 + random.below(2), 1 + random.below(3)}, {x, y, step()}};
  }
  object.shape = group;
  return object;
}

inline Scene mixed_scene(Random& random, int objects, double scale) {
  Scene scene;
  for (int i = 0; i < objects; ++i) scene.objects.push_back(random_object(random, scale));
  scene.objects.push_back(object_of(Plane{{0, -12 * scale, 0}, {0.1, 1, 0.2}}));
  return scene;
}

/// A chain of nodes, each with as many leaves as it holds and the next node, all in the same box.
inline HugeVector<Bvh::Node> leaves_of(std::size_t things, const Box32& box) {
  HugeVector<Bvh::Node> nodes;
  for (std::size_t first = 0; first < things;) {
    Bvh::Node node;
    const auto add = [&](BvhChild child) {
      node.children[node.boxes.count] = child;
      node.boxes.add(box);
    };
    while (first < things && node.boxes.count + 1 < BoxSet::size) {
      const std::size_t count = std::min<std::size_t>(Bvh::largest_leaf, things - first);
      add(BvhChild::leaf(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)));
      first += count;
    }
    if (first < things) add(BvhChild::node(static_cast<std::uint32_t>(nodes.size() + 1)));
    nodes.push_back(node);
  }
  return nodes;
}

/// With nothing left out of any search: all things tried in turn, and all triangles of a mesh.
inline Geometry without_index(Geometry geometry) {
  const Box32 everything{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
  for (Space& space : geometry.spaces) {
    space.rest.resize(space.items.size());
    std::iota(space.rest.begin(), space.rest.end(), 0U);
    space.boxes.assign(space.items.size(), everything);
    space.bvh = space.balls.bvh = {};
  }
  for (SharedMesh& mesh : geometry.meshes) {
    MeshIndex plain = *mesh;
    if (!plain.bvh.nodes.empty()) {
      plain.bvh.nodes = leaves_of(plain.bvh.order.size(), everything);
      plain.pack();
    }
    mesh = std::make_shared<const MeshIndex>(std::move(plain));
  }
  for (InstanceGrid& grid : geometry.grids) grid.box = {{-1e30, -1e30, -1e30}, {1e30, 1e30, 1e30}};
  return geometry;
}
inline World without_index(World world) {
  world.of_objects = std::make_shared<const Geometry>(without_index(*world.of_objects));
  world.of_lights = without_index(std::move(world.of_lights));
  world.few_balls = false;
  return world;
}

/// Rays from among the things and from outside; every other one along an axis, in a plane of two
/// axes, or through places that boxes begin at.
inline Ray<double> random_ray(Random& random, double scale, const World& world) {
  Ray<double> ray{random.point(15) * scale, random.direction()};
  const auto& boxes = world.of_objects->spaces.front().boxes;
  const Box32& box = boxes[static_cast<std::size_t>(random.below(static_cast<int>(boxes.size())))];
  switch (random.below(8)) {
    case 0: ray.direction.x = 0; break;
    case 1: ray.direction = {0, random.chance(0.5) ? 1.0 : -1.0, 0}; break;
    case 2: ray.direction = {-0.0, 0.0, -1}; break;
    case 3:  // in a plane of a box, and along it
      ray.origin.x = static_cast<double>(random.chance(0.5) ? box.min.x : box.max.x);
      ray.direction.x = 0;
      break;
    case 4:  // at a corner of a box
      ray.direction = static_cast<Vec3d>(box.max) - ray.origin;
      break;
    default: break;
  }
  const bool usable =
      std::isfinite(dot(ray.direction, ray.direction)) && std::isfinite(ray.origin.x);
  if (!usable || ray.direction == Vec3d{}) return {{}, {0, 0, -1}};
  return {ray.origin, normalize(ray.direction)};
}

template <class Real>
Ray<Real> ray_in(const Ray<double>& ray) {
  return {lift<Real>(ray.origin), normalize(lift<Real>(ray.direction))};
}

/// Rays of floats as one packet.
inline Ray<Wide> packed(const std::vector<Ray<float>>& rays) {
  std::array<std::array<float, Wide::size>, 6> primitives{};
  for (std::size_t k = 0; k < Wide::size; ++k) {
    const auto& [o, d] = rays[k % rays.size()];
    const std::array<float, 6> all{o.x, o.y, o.z, d.x, d.y, d.z};
    for (std::size_t primitive = 0; primitive < 6; ++primitive)
      primitives[primitive][k] = all[primitive];
  }
  const auto at = [&](std::size_t primitive) {
    return Wide::load_unaligned(primitives[primitive].data());
  };
  return {{at(0), at(1), at(2)}, {at(3), at(4), at(5)}};
}

template <class Real>
Hit<Real> hit_of(const World& world, const Ray<Real>& ray) {
  WorkCounter work;
  return closest_hit(world, ray, iota<Real>() >= Real(0), work);
}
inline Hit<float> lane_of(const Hit<Wide>& hit, int k) {
  return {lane(hit.t, k), lane(hit.primitive, k), lane(hit.element, k), lane(hit.instance, k)};
}
template <class Real>
std::array<double, 4> all_of(const Hit<Real>& hit) {
  return {double(hit.t), double(hit.primitive), double(hit.element), double(hit.instance)};
}

}  // namespace tia::test
