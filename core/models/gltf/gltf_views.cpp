// What a glTF document offers to look with and to choose from: cameras, lights, variants.
#include <algorithm>
#include <array>
#include <string>

#include "core/models/gltf/gltf_parts.h"
#include "core/models/gltf/gltf_values.h"

namespace tia::gltf {
namespace {

constexpr double half_turn = 3.141592653589793, right_angle = 1.5707963267948966;

// ---- cameras ------------------------------------------------------------------------------------

void read_perspective(const GltfObject& from, ModelCamera& to) {
  from.needs("yfov", "an angle in radians");
  to.yfov = positive(from, "yfov").value_or(1);
  if (to.yfov >= half_turn)
    from.fault(FaultKind::out_of_range, "yfov", Value(to.yfov), "a number above 0 and below pi");
  to.aspect_ratio = positive(from, "aspectRatio");
  positive(from, "znear");  // rays meet what is nearer, too
}

double read_mag(const GltfObject& from, std::string_view name) {
  from.needs(name, "a number that is not 0");
  const double mag = from.number_or(name, 1, {-1e9, 1e9});
  if (mag == 0) from.fault(FaultKind::out_of_range, name, Value(mag), "a number that is not 0");
  return mag;
}

ModelCamera read_camera(const GltfObject& from) {
  constexpr std::array<std::string_view, 2> kinds{"perspective", "orthographic"};
  ModelCamera to;
  to.name = from.text("name");
  from.needs("type", listed({kinds.begin(), kinds.end()}));
  const auto kind = word(from, "type", kinds);
  if (!kind) return to;
  from.needs(kinds[*kind], "an object, as the camera's type says");
  to.orthographic = *kind == 1;
  from.with(kinds[*kind], [&](const GltfObject& camera) {
    if (!to.orthographic) return read_perspective(camera, to);
    to.xmag = read_mag(camera, "xmag");
    to.ymag = read_mag(camera, "ymag");
  });
  return to;
}

// ---- lights -------------------------------------------------------------------------------------

void read_spot(const GltfObject& from, ModelLight& to) {
  // A right angle of 32 bits is a little larger.
  constexpr double most = static_cast<double>(static_cast<float>(right_angle));
  to.inner_angle = from.number_or("innerConeAngle", to.inner_angle, {0, most});
  to.outer_angle =
      std::min(positive(from, "outerConeAngle", most).value_or(to.outer_angle), right_angle);
  if (to.inner_angle >= to.outer_angle)
    from.fault(FaultKind::conflict, "innerConeAngle", Value(to.inner_angle),
               "an angle below outerConeAngle, which is pi / 4 where it is not there");
}

ModelLight read_light(const GltfObject& from) {
  constexpr auto& kinds = Names<ModelLightKind>::names;
  ModelLight to;
  to.name = from.text("name");
  from.needs("type", listed({kinds.begin(), kinds.end()}));
  to.kind = static_cast<ModelLightKind>(word(from, "type", kinds).value_or(1));
  to.color = from.color_or("color", to.color);
  to.intensity = from.number_or("intensity", to.intensity, {0, Range().max});
  if (to.kind == ModelLightKind::spot)
    from.with("spot", [&](const GltfObject& spot) { read_spot(spot, to); });
  return to;
}

}  // namespace

void read_views(const GltfSource& source, Model& model) {
  source.root.for_each("cameras", [&](const GltfObject& camera, std::size_t) {
    model.cameras.push_back(read_camera(camera));
  });
  source.root.with("extensions", [&](const GltfObject& extensions) {
    extensions.with("KHR_lights_punctual", [&](const GltfObject& all) {
      all.for_each("lights", [&](const GltfObject& light, std::size_t) {
        model.lights.push_back(read_light(light));
      });
    });
    extensions.with("KHR_materials_variants", [&](const GltfObject& all) {
      all.for_each("variants", [&](const GltfObject& variant, std::size_t) {
        variant.needs("name", "the variant's name");
        model.variants.push_back(variant.text("name"));
      });
    });
  });
}

}  // namespace tia::gltf
