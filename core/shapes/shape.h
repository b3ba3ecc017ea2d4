// THE LIST of shapes. A new kind is one file beside this one and one entry here.
#pragma once

#include <concepts>
#include <type_traits>
#include <variant>

#include "core/shapes/algebraic/algebraic.h"
#include "core/shapes/algebraic/blend.h"
#include "core/shapes/algebraic/classics.h"
#include "core/shapes/algebraic/quadric.h"
#include "core/shapes/composite/csg.h"
#include "core/shapes/composite/group.h"
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
/// A kind that holds other objects.
template <class S>
concept IsComposite = requires(const S& s) {
  s.children;
};
/// What a kind must bring: its name and fields, and what it is made of. (A mesh is triangles, for
/// which the tracer has an index.)
template <class S>
concept IsShape = Described<S> &&
    (IsSurface<S> || IsComposite<S> || std::same_as<S, Mesh>)&&requires {
  { S::type } -> std::convertible_to<std::string_view>;
};

/// ShapeList: checks every kind once, where it is listed.
template <IsShape... Kinds>
using ShapeList = std::variant<Kinds...>;

using Shape = ShapeList<Sphere, Plane, Disc, Box, Cylinder, Cone, Capsule, Triangle, Mesh, Torus,
                        Quadric, Algebraic, Steiner, BarthSextic, Chmutov, Heart, Clebsch, Cayley,
                        Implicit, Explicit, Parametric, Blend, Voxels, Csg, Group>;

namespace detail {

template <class... Forms>
struct FormsOf {
  using Variant = std::variant<Forms...>;
};
// Appends what each kind prepares to, once.
template <class Done, class... Kinds>
struct Collected : Done {};
template <class... Forms, class Kind, class... Kinds>
struct Collected<FormsOf<Forms...>, Kind, Kinds...> : Collected<FormsOf<Forms...>, Kinds...> {};
template <class... Forms, IsSurface Kind, class... Kinds>
struct Collected<FormsOf<Forms...>, Kind, Kinds...>
    : std::conditional_t<
          (std::same_as<decltype(prepare(std::declval<const Kind&>())), Forms> || ...),
          Collected<FormsOf<Forms...>, Kinds...>,
          Collected<FormsOf<Forms..., decltype(prepare(std::declval<const Kind&>()))>, Kinds...>> {
};
template <class List>
struct FormList;
template <class... Kinds>
struct FormList<std::variant<Kinds...>> {
  using Variant = typename Collected<FormsOf<>, Kinds...>::Variant;
};

}  // namespace detail

/// Form: what the kinds of the list prepare to, several of them perhaps to the same.
using Form = detail::FormList<Shape>::Variant;

}  // namespace tia
