// PathLights: all that the path tracer asks for light but the skies: the scene's lights, and the
// areas of its luminous objects.
#pragma once

#include <variant>
#include <vector>

#include "core/accel/world/world_light.h"
#include "core/lights/areas.h"
#include "core/lights/light_tree.h"
#include "core/lights/lit_spans.h"
#include "core/math/transform.h"
#include "core/shapes/shape.h"

namespace tia {

using PathForm = std::variant<PointForm, DirectionalForm, SpotForm, SphereForm, SunForm,
                              TriangleArea, QuadArea, DiscArea, BoxArea, CylinderArea>;

/// PathLight: `color` is an intensity, an irradiance or a radiance.
struct PathLight {
  PathForm form;
  Constant color;
  int primitive = -1;  ///< its surface; -1: none
  int instance = 0;
  int element = -1;  ///< the surface's; -1: all of it
  /// Whether the surface hides no part of itself that is asked for, and is left out of shadows.
  bool is_bare = false;
};

/// Adds the light's areas at that place, one light each, if there are not too many; none for a
/// shape that has no sampler, whose light is found by the directions that surfaces draw.
/// Space/units: `place` goes to the coordinates that the lights are wanted in.
constexpr std::size_t most_areas = 1 << 15;
void add_areas(const Shape& shape, const Affine& place, const PathLight& light,
               std::vector<PathLight>& lights);
/// Translates a light.
void move_by(PathLight& light, const Vec3d& way);
/// Where along a line it shines. Domain: a unit direction.
LitSpans lit_spans(const PathLight& light, const Vec3d& origin, const Vec3d& direction);

/// Choice: a light, and the chance that it had; light -1: none.
struct PathChoice {
  int light = -1;
  double chance = 0;
};

class PathLights {
 public:
  PathLights() = default;
  /// Of the scene's lights and the areas of objects. `skies`: how many there are.
  PathLights(const std::vector<WorldLight>& lights, const std::vector<PathLight>& areas,
             std::size_t skies);

  /// One of the lights or, from size() on, of the skies: those infinitely far and all others
  /// together are each as likely; of these up to four by their power, more by a tree.
  PathChoice choose(const Vec3d& p, const Vec3d& n, double u) const;
  double chance(int light, const Vec3d& p, const Vec3d& n) const;
  /// The light of a point that a ray has hit; -1: none.
  int at(int primitive, int instance, int element) const;

  const PathLight& operator[](int i) const { return lights_[static_cast<std::size_t>(i)]; }
  int size() const { return static_cast<int>(lights_.size()); }
  /// The first that is infinitely far; all after it are too.
  int first_endless() const { return near_; }
  bool is_near(int light) const { return light < near_; }
  /// Whether what chances near lights have depends on the place.
  bool knows_places() const { return near_ > few; }
  /// Domain: a near one.
  const Vec3d& middle(int light) const { return middles_[static_cast<std::size_t>(light)]; }
  bool empty() const { return groups_ == 0; }

 private:
  static constexpr int few = 4;
  double share(int light) const { return shares_[static_cast<std::size_t>(light)]; }

  std::vector<PathLight> lights_;  // the near ones first, sorted by what rays hit
  int near_ = 0, groups_ = 0;
  std::vector<Vec3d> middles_;  // of the near ones
  std::vector<double> shares_;  // of the power, where there are few
  LightTree tree_;
};

}  // namespace tia
