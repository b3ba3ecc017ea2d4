// The tree of one ray in whitted, and the few scenes that tests of light and shading are made of.
#pragma once

#include "tests/core/support.h"

namespace tia::test {

inline RenderOptions at_depth(int max_depth) {
  RenderOptions options;
  options.integrator = IntegratorName::whitted;
  options.max_depth = max_depth;
  return options;
}

/// What a free ray finds.
inline std::unique_ptr<RayNode> tree(const Scene& scene, const Vec3d& origin, const Vec3d& way,
                                     const RenderOptions& options = at_depth(5)) {
  return explain(scene, compile(scene), Ray<double>{origin, normalize(way)}, options).tree;
}

/// The term of that name, or null.
inline const Term* term(const RayNode& node, TermName name) {
  for (const Term& each : node.terms)
    if (each.name == name) return &each;
  return nullptr;
}
inline const RayNode* child(const RayNode& node, TermName name) {
  const Term* found = term(node, name);
  return found == nullptr ? nullptr : found->node.get();
}

inline Finish dark() {
  Finish finish;
  finish.diffuse = 0;
  return finish;
}
/// What is seen through and mirrors as Fresnel says.
inline Finish glass(double ior) {
  Finish finish = dark();
  finish.transmission = 1;
  finish.ior = ior;
  finish.fresnel = true;
  return finish;
}
/// What is seen through and mirrors nothing.
inline Finish clear_glass(double ior) {
  Finish finish = glass(ior);
  finish.fresnel = false;
  return finish;
}
inline Finish mirror(double reflection, const Color& emission = {}) {
  Finish finish = dark();
  finish.reflection = reflection;
  finish.emission = emission;
  return finish;
}
inline Object object(const Shape& shape, const Finish& finish) {
  Object is;
  is.shape = shape;
  is.material = MaterialRef(Material{finish});
  return is;
}

inline Light light_of(const decltype(Light::kind)& kind, const Color& color = {1, 1, 1}) {
  Light light;
  light.kind = kind;
  light.color = color;
  return light;
}
/// A way at an angle to the y axis, towards x.
inline Vec3d slanted(double angle, bool downwards = true) {
  return {std::sin(angle), downwards ? -std::cos(angle) : std::cos(angle), 0};
}

inline void expect_near(const Vec3f& got, const Vec3d& expected, double tolerance) {
  EXPECT_NEAR(got.x, expected.x, tolerance);
  EXPECT_NEAR(got.y, expected.y, tolerance);
  EXPECT_NEAR(got.z, expected.z, tolerance);
}

}  // namespace tia::test
