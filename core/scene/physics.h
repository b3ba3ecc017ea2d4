// Physics: which objects are bodies, and what they bounce off, as it is written. How they move is
// core/motion's.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/input/codec.h"

namespace tia {

/// PhysicsSolver: exact follows balls from one event to the next; rigid lets bodies turn and rub,
/// in steps.
enum class PhysicsSolver { exact, rigid };
template <>
struct Names<PhysicsSolver> {
  static constexpr std::array<std::string_view, 2> names{"exact", "rigid"};
};

/// The specs that bodies, what is fixed, and pairs have in common.
namespace physics_spec {
inline constexpr Spec object{.about = "an object's name, or its JSON Pointer, such as /objects/2",
                             .required = true,
                             .max_bytes = 512};
inline constexpr Spec restitution{
    .about =
        "of the speed at which two approach, the share with which they part, is the product of "
        "both's",
    .min = 0,
    .max = 1};
inline constexpr Spec friction{
    .about =
        "by rigid: what hinders two from sliding is the geometric mean of both's times what "
        "presses them together",
    .min = 0,
    .max = 100};
}  // namespace physics_spec

/// PhysicsBody: an object that moves as its mass wants.
struct PhysicsBody {
  static constexpr std::string_view schema_name = "body";
  static constexpr double most_mass = 1e15, most_speed = 1e9;
  std::string object;
  std::optional<double> mass, density;  ///< one of them
  Vec3d velocity{}, spin{};
  double restitution = 1, friction = 0.5;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    using B = PhysicsBody;
    visit("object", &B::object, physics_spec::object);
    visit("mass", &B::mass,
          Spec{.about = "its mass", .min = 0, .max = most_mass, .open_min = true});
    visit("density", &B::density,
          Spec{.about = "instead: its mass for each unit of its volume; of a mesh that is closed",
               .min = 0,
               .max = most_mass,
               .open_min = true});
    visit("velocity", &B::velocity,
          Spec{.about = "of its centre of mass when it is first there",
               .unit = "units a second",
               .min = -most_speed,
               .max = most_speed});
    visit("spin", &B::spin,
          Spec{.about = "by rigid: how it turns then, about the scene's axes",
               .unit = "radians a second",
               .min = -1e6,
               .max = 1e6});
    visit("restitution", &B::restitution, physics_spec::restitution);
    visit("friction", &B::friction, physics_spec::friction);
  }
  /// Neither mass nor density, or both.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const PhysicsBody&) const = default;
};

/// PhysicsFixed: an object that stands still and that bodies meet.
struct PhysicsFixed {
  static constexpr std::string_view schema_name = "fixed";
  std::string object;
  double restitution = 1, friction = 0.5;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("object", &PhysicsFixed::object, physics_spec::object);
    visit("restitution", &PhysicsFixed::restitution, physics_spec::restitution);
    visit("friction", &PhysicsFixed::friction, physics_spec::friction);
  }
  bool operator==(const PhysicsFixed&) const = default;
};

/// PhysicsPair: what holds of two in place of the product and the mean.
struct PhysicsPair {
  static constexpr std::string_view schema_name = "pair";
  std::vector<std::string> objects;  ///< two
  std::optional<double> restitution, friction;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("objects", &PhysicsPair::objects,
          Spec{.about = "two of bodies and fixed, as they are called there",
               .required = true,
               .min_items = 2,
               .max_bytes = 512});
    visit("restitution", &PhysicsPair::restitution,
          Spec{.about = "of this pair; else the product", .min = 0, .max = 1});
    visit("friction", &PhysicsPair::friction,
          Spec{.about = "of this pair; else the geometric mean", .min = 0, .max = 100});
  }
  /// More than two objects, or one twice.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const PhysicsPair&) const = default;
};

/// Physics: bodies and what they bounce off.
struct Physics {
  static constexpr std::string_view schema_name = "physics";
  Vec3d gravity{0, -9.81, 0};
  double duration = 5;
  PhysicsSolver solver = PhysicsSolver::exact;
  std::vector<PhysicsBody> bodies;
  std::vector<PhysicsFixed> fixed;
  std::vector<PhysicsPair> pairs;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("gravity", &Physics::gravity,
          Spec{.about = "how everything is accelerated",
               .unit = "units a second squared",
               .min = -1e9,
               .max = 1e9});
    visit("duration", &Physics::duration,
          Spec{.about = "how long motion is followed",
               .unit = "s",
               .min = 0,
               .max = 86400,
               .open_min = true});
    visit("solver", &Physics::solver,
          Spec{.about = "exact: balls, without spin and friction, from one collision to the next; "
                        "rigid: also boxes, cylinders, cones, capsules and the hulls of meshes, "
                        "with both, in steps of 1/240 s"});
    visit("bodies", &Physics::bodies,
          Spec{.about = "what moves", .required = true, .min_items = 1});
    visit("fixed", &Physics::fixed, Spec{.about = "what stands still and is bounced off"});
    visit("pairs", &Physics::pairs, Spec{.about = "what holds of single pairs"});
  }
  /// Spin by exact.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Physics&) const = default;
};

}  // namespace tia
