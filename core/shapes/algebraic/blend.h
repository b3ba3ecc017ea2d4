// The blend: solids that grow into one another, by their signed distance functions.
#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "core/input/codec.h"
#include "core/input/transform_steps.h"
#include "core/shapes/composite/csg.h"
#include "core/shapes/formula/implicit.h"
#include "core/shapes/simple/box.h"
#include "core/shapes/simple/capsule.h"
#include "core/shapes/simple/cone.h"
#include "core/shapes/simple/torus.h"

namespace tia {

struct Blended;

/// Blend. Surface: f = 0, f the children's signed distance functions d joined with a radius r: of a
/// union max(r, min d) - |max(0, r - d)|, the length of the vector of all; of an intersection that
/// of the insides turned out; a difference is the first without the others. Where two surfaces meet
/// at right angles, a quarter of a circle of that radius joins them; farther than r from the others
/// each child is itself. Inside where f < 0.
/// Space/units: scene units, object space.
/// Source: Mercury, hg_sdf (2015), fOpUnionRound, for two; here for any number, in any order.
struct Blend {
  static constexpr std::string_view type = "blend";
  Operation operation = Operation::union_;
  double radius = 0;
  std::vector<Blended> children;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("operation", &Blend::operation,
          Spec{.about = "what is kept of the children", .required = true});
    visit("radius", &Blend::radius,
          Spec{.about = "of the round that joins them; 0 is an edge",
               .min = 0,
               .max = 1e9,
               .required = true});
    visit("children", &Blend::children,
          Spec{.about = "solids: "
                        "sphere, box, cylinder, capsule, torus, implicit, blend",
               .required = true,
               .min_items = 1});
  }
  /// More than a function may cost.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Blend&) const;
};

/// Blended: a child of a blend. It wears the blend's material.
struct Blended {
  static constexpr std::string_view schema_name = "blended";
  /// THE LIST of what has a signed distance function (blend.cpp).
  std::variant<Sphere, Box, Cylinder, Capsule, Torus, Implicit, Blend> shape;
  TransformSteps transform;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit.one_of(&Blended::shape, Spec{.about = "the kind of solid", .required = true});
    visit("transform", &Blended::transform,
          Spec{.about = "steps that place it, the first step first"});
  }
  bool operator==(const Blended&) const = default;
};

IsosurfaceForm prepare(const Blend& blend);
/// Without searching for the surface in it.
Aabb bounds(const Blend& blend);

}  // namespace tia
