#include "core/motion/exact_world.h"

#include <cmath>

#include "core/motion/body_mass.h"
#include "core/motion/similarity.h"

namespace tia {
namespace {

constexpr const char* known_to_exact =
    "by exact a plane, sphere, box, cylinder, capsule, triangle, mesh, walls or a group of them; "
    "what is round scaled alike on every axis";

/// FixedSurfaces: the surfaces of one object that stands still. Each function says whether the
/// solver knows it.
class FixedSurfaces {
 public:
  explicit FixedSurfaces(std::vector<FixedShape>& into) : into_(into) {}

  bool add(const Object& object, const Affine& parent) {
    const Affine place = parent * object.transform.affine();
    return std::visit([&](const auto& shape) { return this->add(shape, place); }, object.shape);
  }

 private:
  bool add(const Plane& plane, const Affine& place) {
    return put(FixedPlane{place.point(plane.point), place.inverse().row(plane.normal)});
  }
  bool add(const Sphere& sphere, const Affine& place) {
    const auto scale = similarity_of(place);
    return scale && put(FixedSphere{place.point(sphere.center), sphere.radius * *scale});
  }
  bool add(const Box& box, const Affine& place) {
    const Vec3d size = box.max - box.min;
    return put(
        FixedBox{place.point(box.min), {place.x * size.x, place.y * size.y, place.z * size.z}});
  }
  bool add(const Cylinder& c, const Affine& place) {
    const auto scale = similarity_of(place);
    return scale && put(FixedCylinder{place.point(c.base), place.point(c.cap), c.radius * *scale});
  }
  bool add(const Capsule& c, const Affine& place) {
    const auto scale = similarity_of(place);
    if (!scale) return false;
    if (c.base == c.cap) return put(FixedSphere{place.point(c.base), c.radius * *scale});
    return put(FixedCapsule{place.point(c.base), place.point(c.cap), c.radius * *scale});
  }
  bool add(const Triangle& t, const Affine& place) {
    return put(FixedMesh{{place.point(t.a), place.point(t.b), place.point(t.c)}, {{{0, 1, 2}}}});
  }
  bool add(const Mesh& mesh, const Affine& place) {
    FixedMesh fixed;
    const auto& p = mesh.positions.values.get();
    for (std::size_t i = 0; i + 2 < p.size(); i += 3)
      fixed.points.push_back(place.point(Vec3d{p[i], p[i + 1], p[i + 2]}));
    const auto& n = mesh.indices.values.get();
    for (std::size_t i = 0; i + 2 < n.size(); i += 3)
      fixed.triangles.push_back({n[i], n[i + 1], n[i + 2]});
    return put(std::move(fixed));
  }
  bool add(const Group& group, const Affine& place) {
    if (group.repeat) return false;
    return add(group.children, place);
  }
  bool add(const Walls& walls, const Affine& place) { return add(children_in(walls), place); }
  bool add(const std::vector<Object>& children, const Affine& place) {
    bool known = true;
    for (const Object& child : children) known = add(child, place) && known;
    return known;
  }
  template <class Other>
  bool add(const Other&, const Affine&) {
    return false;
  }

  bool put(FixedShape shape) {
    into_.push_back(std::move(shape));
    return true;
  }

  std::vector<FixedShape>& into_;
};

// The ball that a body is: with a mass of 1 where a fault says that it has none.
MovingBall ball_of(const MovingBody& body, const Place& at, Faults& faults) {
  MovingBall ball;
  ball.velocity = body.said->velocity;
  ball.enters = body.enters;
  ball.leaves = body.leaves;
  if (body.what.object == nullptr) return ball;  // a fault says so already
  const Affine place = body.what.place();
  const auto* sphere = std::get_if<Sphere>(&body.what.object->shape);
  const auto scale = similarity_of(place);
  if (sphere == nullptr || !scale) {
    faults.add({FaultKind::conflict, at.at("object").pointer(), Value(body.said->object),
                "by exact a sphere, scaled alike on every axis; by the solver rigid others, too"});
    return ball;
  }
  ball.center = place.point(sphere->center);
  ball.radius = sphere->radius * *scale;
  ball.mass = mass_of(body, at, faults);
  return ball;
}

}  // namespace

Lowered<ExactWorld> exact_world(const Physics& physics, const SceneBodies& bodies, const Place& at,
                                Faults& faults) {
  const auto add_body = [&](const MovingBody& body, const Place& where, ExactWorld& world) {
    world.balls.push_back(ball_of(body, where, faults));
  };
  const auto add_fixed = [](const Object& object, const Affine& parent, auto& fixed) {
    return FixedSurfaces(fixed).add(object, parent);
  };
  return lowered<ExactWorld>(physics, bodies, at, faults, add_body, add_fixed, known_to_exact);
}

}  // namespace tia
