#include "core/scene/model_lights.h"

#include <algorithm>

#include "core/input/transform_steps.h"
#include "core/math/onb.h"

namespace tia {
namespace {

// The most that a scene may give as intensity, and as a channel of a colour.
constexpr double most_light = 1e6;

Light::Kinds kind_at(const ModelLight& own, const Affine& place) {
  const Vec3d along = unit(place.z) * -1.0;
  constexpr double degrees = 180 / pi;
  switch (own.kind) {
    case ModelLightKind::directional: return DirectionalLight{along};
    case ModelLightKind::spot:
      return SpotLight{place.offset, place.offset + along, own.inner_angle * degrees,
                       own.outer_angle * degrees, 0};
    case ModelLightKind::point: break;
  }
  return PointLight{place.offset};
}

Light placed_light(const ModelLight& own, const Affine& place) {
  Light light;
  light.kind = kind_at(own, place);
  light.intensity = std::min(own.intensity, most_light);
  // What an intensity cannot say the colour does.
  const double more = std::max(own.intensity / most_light, 1.0);
  light.color = {std::min(own.color.r * more, most_light), std::min(own.color.g * more, most_light),
                 std::min(own.color.b * more, most_light)};
  return light;
}

}  // namespace

std::vector<Light> model_lights(const Model& model, const Pose& pose, const Affine& to_scene) {
  std::vector<Light> lights;
  for (const ModelIndex number : pose.shown) {
    const MaybeIndex light = model.nodes[number].light;
    const Affine place = to_scene * pose.places[number];
    if (light && is_usable(place)) lights.push_back(placed_light(model.lights[*light], place));
  }
  return lights;
}

}  // namespace tia
