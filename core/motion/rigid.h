// Rigid bodies that turn and rub, by Bullet 3, in steps of 1/240 s. Only rigid.cpp knows Bullet.
// Its numbers are the same on one machine; processors may differ in them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <stop_token>
#include <variant>
#include <vector>

#include "core/math/quaternion.h"
#include "core/motion/motion.h"

namespace tia {

// Shapes, each in a frame of its own whose origin is its middle. Space/units: the scene's.
struct RigidSphere {
  double radius = 1;
};
struct RigidBox {
  Vec3d half{};
};
/// About the frame's y.
struct RigidCylinder {
  double radius = 1, half_height = 1;
};
/// Its tip is up y; the origin is half way to it.
struct RigidCone {
  double radius = 1, half_height = 1;
};
/// A segment along y, and all that is so near to it.
struct RigidCapsule {
  double radius = 1, half_height = 1;
};
/// The convex hull of points.
struct RigidHull {
  std::vector<Vec3d> points;
};
/// Through the origin; the solid lies behind it. It stands still.
struct RigidPlane {
  Vec3d normal{0, 1, 0};
};
/// Triangles that stand still.
struct RigidMesh {
  std::vector<Vec3d> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};
using RigidShape = std::variant<RigidSphere, RigidBox, RigidCylinder, RigidCone, RigidCapsule,
                                RigidHull, RigidPlane, RigidMesh>;

/// RigidPart: a shape, and its frame in the scene, right-handed, of axes of length 1.
struct RigidPart {
  RigidShape shape;
  Affine frame{};
};

/// RigidBody: what moves. Its own frame has its centre of mass as origin and its principal axes.
struct RigidBody {
  RigidPart part;
  Affine frame{};
  double mass = 1, radius = 1;  ///< radius: around its centre of mass
  Vec3d moments{1, 1, 1};       ///< of inertia, about the frame's axes
  Vec3d velocity{}, spin{};
  double enters = 0, leaves = std::numeric_limits<double>::infinity();
};

struct RigidWorld {
  Vec3d gravity{};
  double duration = 0;
  std::vector<RigidBody> bodies;
  std::vector<RigidPart> fixed;
  /// Of a pair, numbered as BodyContact's.
  std::function<double(std::size_t a, std::size_t b)> restitution, friction;
};

/// RigidPose: where a body's centre of mass is, and how it has turned since it entered.
struct RigidPose {
  double time = 0;
  Vec3d center{};
  Quaternion rotation{0, 0, 0, 1};
};

/// RigidMotion. Shape: a pose a step of each body, from the step on in which it enters.
struct RigidMotion {
  std::vector<std::vector<RigidPose>> poses;
  std::vector<BodyContact> contacts;  ///< those that begin, Motion::most_records at most
  std::vector<BodyEnergy> energy;     ///< of steps, Motion::most_records at most
  std::size_t steps = 0;              ///< of all bodies
};

/// Steps of a second.
inline constexpr int rigid_steps = 240;

/// Errors: BodiesOverlap (core/motion/exact.h) as a body enters; Stopped; std::bad_alloc.
/// Source: Coumans, "Bullet physics simulation" (SIGGRAPH 2015 courses); sequential impulses:
/// Catto, "Iterative dynamics with temporal coherence" (GDC 2005).
RigidMotion solve_rigid(const RigidWorld& world, const std::stop_token& stop = {});

}  // namespace tia
