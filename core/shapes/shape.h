// THE LIST of shapes. A new kind is one file beside this one and one entry here.
#pragma once

#include <concepts>
#include <variant>
#include <vector>

#include "core/input/kinds.h"
#include "core/shapes/algebraic/algebraic.h"
#include "core/shapes/algebraic/blend.h"
#include "core/shapes/algebraic/classics.h"
#include "core/shapes/algebraic/quadric.h"
#include "core/shapes/composite/csg.h"
#include "core/shapes/composite/group.h"
#include "core/shapes/composite/placed_model.h"
#include "core/shapes/composite/walls.h"
#include "core/shapes/crossing.h"
#include "core/shapes/formula/explicit.h"
#include "core/shapes/formula/implicit.h"
#include "core/shapes/mesh/mesh.h"
#include "core/shapes/parametric/parametric.h"
#include "core/shapes/simple/box.h"
#include "core/shapes/simple/capsule.h"
#include "core/shapes/simple/cone.h"
#include "core/shapes/simple/disc.h"
#include "core/shapes/simple/plane.h"
#include "core/shapes/simple/sphere.h"
#include "core/shapes/simple/torus.h"
#include "core/shapes/simple/triangle.h"
#include "core/shapes/voxels/voxels.h"

namespace tia {

/// A kind that is a surface of its own: prepare() makes a form of its description.
template <class S>
concept IsSurface = requires(const S& s) {
  { prepare(s) } -> IsForm;
};
/// A kind whose elements wear several materials, told apart by numbers: it says which numbers an
/// object's materials leave without one.
template <class S>
concept IsNumbered = requires(const S& s, const Place& at, Faults& faults) {
  { s.check_materials(std::size_t{}, at, faults) } -> std::same_as<void>;
};
/// Numbers are checked where they are read if, and only if, the form tells them.
template <class S>
concept ChecksItsNumbers = !IsSurface<S> || requires {
  requires IsNumbered<S>
  == NumbersMaterials<FormOf<S>>;
};
/// A kind that holds other objects: its children, and whether they are `one_object`, parts of one
/// solid, or objects of their own.
template <class S>
concept IsComposite = requires(const S& s) {
  { children_in(s) } -> std::same_as<const std::vector<Object>&>;
  { S::one_object } -> std::convertible_to<bool>;
};
/// What a kind must bring: its name and fields, and what it is made of. (A mesh is triangles, for
/// which the tracer has an index.)
template <class S>
concept IsShape = IsKind<S> && ChecksItsNumbers<S> &&
    (IsSurface<S> || IsComposite<S> || std::same_as<S, Mesh>);

/// ShapeList: checks every kind once, where it is listed.
template <IsShape Kind>
using ListedShape = Kind;
template <class... Kinds>
using ShapeList = std::variant<ListedShape<Kinds>...>;

using Shape =
    ShapeList<Sphere, Plane, Disc, Box, Cylinder, Cone, Capsule, Triangle, Mesh, Torus, Quadric,
              Algebraic, Steiner, BarthSextic, Chmutov, Heart, Clebsch, Cayley, Implicit, Explicit,
              Parametric, Blend, Voxels, Csg, Group, PlacedModel, Walls>;

/// Form: what the kinds of the list prepare to, several of them perhaps to the same.
using Form = FormsOf<Shape>;

}  // namespace tia
