// THE LIST of shapes. A new kind is one file beside this one and one entry here.
#pragma once

#include <concepts>
#include <variant>

#include "core/shapes/sphere.h"

namespace tia {

/// What a kind must bring: its fields, the nearest root in each scalar and the outward normal.
template <class S>
concept IsShape = Described<S> &&
    requires(const S& s, const RootRay<float>& ray, const RootRay<double>& exact,
             const RootRay<Wide>& wide, const Vec3<Wide>& p) {
  { S::type } -> std::convertible_to<std::string_view>;
  { intersect(s, ray) } -> std::same_as<float>;
  { intersect(s, exact) } -> std::same_as<double>;
  { intersect(s, wide) } -> std::same_as<Wide>;
  { normal(s, p) } -> std::same_as<Vec3<Wide>>;
};

/// ShapeList: checks every kind once, where it is listed.
template <IsShape... Kinds>
using ShapeList = std::variant<Kinds...>;

using Shape = ShapeList<Sphere>;

}  // namespace tia
