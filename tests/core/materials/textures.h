// The short way from a texture's JSON to its colours.
#pragma once

#include "core/materials/texture.h"
#include "tests/core/faults.h"
#include "tests/core/support.h"

namespace tia::test {

inline Texture texture(const std::string& json) {
  return read_described<Texture>(parse_json(json));
}
inline std::vector<Fault> texture_faults(const std::string& json) {
  return faults_of([&] { texture(json); });
}
inline TextureForm texture_form(const std::string& json) { return prepare(texture(json)); }

/// The colour of a pattern of space at a point.
inline Vec3d color_at(const TextureForm& form, const Vec3d& p, double blur = 0) {
  return color_at(form, p, Vec2d{}, blur);
}
/// The red of it, of patterns whose red is the number looked for.
inline double red_at(const TextureForm& form, const Vec3d& p, double blur = 0) {
  return color_at(form, p, blur).x;
}

inline void expect_color(const Vec3d& got, const Vec3d& expected, double near) {
  EXPECT_NEAR(got.x, expected.x, near);
  EXPECT_NEAR(got.y, expected.y, near);
  EXPECT_NEAR(got.z, expected.z, near);
}

}  // namespace tia::test
