#include "core/scene/still_studio.h"

#include <cmath>

#include "core/math/deterministic.h"

namespace tia {
namespace {

// Panel: a square of light. Angles are the camera's azimuth's, elevations from the horizon.
struct Panel {
  double azimuth_degrees, elevation_degrees;
  double distance;    // of the centre, in radii
  double irradiance;  // at the ball's centre
};

Light light_of(Light::Kinds kind, double intensity) {
  Light light;
  light.kind = std::move(kind);
  light.intensity = intensity;
  return light;
}

// How bright it is for that irradiance, where a panel of radiance 1 gives `of_one`.
double shining(const StudioStand& stand, double irradiance, double of_one) {
  const bool is_path = stand.integrator == IntegratorName::path;
  return irradiance / (is_path ? of_one : pi);
}

Light panel_light(const StudioStand& stand, const Panel& panel) {
  const double azimuth = stand.azimuth_degrees + panel.azimuth_degrees, r = stand.ball.radius;
  const Basis axes = orbit_basis(azimuth, panel.elevation_degrees);
  const Vec3d middle = stand.ball.center + axes.w * (panel.distance * r);
  const double q = 1 / std::sqrt(1 + panel.distance * panel.distance);
  return light_of(QuadLight{middle - (axes.u + axes.v) * r, axes.u * (2 * r), axes.v * (2 * r)},
                  shining(stand, panel.irradiance, 4 * q * atan_of(q)));
}

Light directional_light(const StudioStand& stand, const Vec3d& direction, double irradiance) {
  return light_of(DirectionalLight{direction}, shining(stand, irradiance, 1));
}

// Gathers a studio's light.
class Lighting {
 public:
  explicit Lighting(const StudioStand& stand) : stand_(stand) {}

  void panel(const Panel& panel) { made_.lights.push_back(panel_light(stand_, panel)); }
  void from(double azimuth_degrees, double elevation_degrees, double irradiance) {
    const double azimuth = stand_.azimuth_degrees + azimuth_degrees;
    along(orbit_direction(azimuth, elevation_degrees) * -1.0, irradiance);
  }
  void along(const Vec3d& direction, double irradiance) {
    made_.lights.push_back(directional_light(stand_, direction, irradiance));
  }
  void sky(const Color& radiance) {
    if (stand_.integrator != IntegratorName::path) return void(made_.ambient_light = radiance);
    Light light = light_of(SkyLight{}, 1);
    light.color = radiance;
    made_.lights.push_back(light);
  }
  StudioLight made() && { return std::move(made_); }

 private:
  const StudioStand& stand_;
  StudioLight made_;
};

}  // namespace

StudioLight studio_light(Studio studio, const StudioStand& stand) {
  Lighting lighting(stand);
  switch (studio) {
    case Studio::soft:
      lighting.panel({-45, 45, 3, pi});
      lighting.panel({60, 20, 4, pi / 4});
      lighting.panel({180, 40, 3, pi / 2});
      lighting.sky({0.3, 0.3, 0.3});
      break;
    case Studio::neutral: lighting.sky({1, 1, 1}); break;
    case Studio::sun:
      lighting.from(-45, 50, 0.9 * pi);
      lighting.sky({0.2, 0.25, 0.35});
      break;
    case Studio::dark:
      lighting.panel({-110, 45, 3, pi});
      lighting.sky({0.02, 0.02, 0.02});
      break;
    case Studio::headlight: lighting.along(stand.view, pi); break;
    case Studio::none: break;
  }
  return std::move(lighting).made();
}

}  // namespace tia
