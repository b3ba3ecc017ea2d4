#include "core/models/check_parts.h"

#include <algorithm>

namespace tia {
namespace {

constexpr double far = 1e9, bright = 1e6;

void must(bool holds, const Place& at, const char* allowed, Faults& faults) {
  if (!holds) faults.add({FaultKind::out_of_range, at.pointer(), std::nullopt, allowed});
}
bool within(double x, double min, double max) { return x >= min && x <= max; }
bool within(const Color& c, double max) {
  return within(c.r, 0, max) && within(c.g, 0, max) && within(c.b, 0, max);
}
template <class List>
bool all_within(const List& list, double most) {
  return std::ranges::all_of(list, [most](double x) { return within(x, -most, most); });
}

void check_use(const MaybeTexture& use, std::size_t textures, const Place& at, Faults& faults) {
  if (!use) return;
  must(use->texture < textures, at.at("texture"), "the number of a texture", faults);
  must(use->uv_set < 2, at.at("uv_set"), "0 or 1", faults);
  must(all_within(use->offset, far) && all_within(use->scale, far) &&
           within(use->rotation, -far, far) && within(use->strength, -far, far),
       at, "finite numbers", faults);
}

void check_sizes(const ModelPart& part, const Place& at, Faults& faults) {
  const std::size_t n = part.vertices();
  const auto fits = [n](const auto& list, std::size_t each) {
    return list.empty() || list.size() == each * n;
  };
  must(n > 0 && part.positions.size() == 3 * n, at.at("positions"), "three numbers a vertex",
       faults);
  must(fits(part.normals, 3) && fits(part.tangents, 4) && fits(part.uvs[0], 2) &&
           fits(part.uvs[1], 2) && fits(part.colors, 4) &&
           (fits(part.joints, 4) || fits(part.joints, 8)) &&
           part.weights.size() == part.joints.size(),
       at, "lists of as many vertices as positions", faults);
  for (const MorphTarget& each : part.targets)
    must(fits(each.positions, 3) && fits(each.normals, 3) && fits(each.tangents, 3),
         at.at("targets"), "lists of as many vertices as positions", faults);
  must(part.points ? part.indices.empty() : part.indices.size() % 3 == 0, at.at("indices"),
       "three a triangle, of points none", faults);
}

bool are_normals(const std::vector<float>& normals) {
  for (std::size_t i = 0; i + 2 < normals.size(); i += 3)
    if (normals[i] == 0 && normals[i + 1] == 0 && normals[i + 2] == 0) return false;
  return all_within(normals, far);
}

void check_place(const Placement& own, const Place& at, Faults& faults) {
  const auto& q = own.rotation;
  const double squared = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  must(within(own.translation.x, -far, far) && within(own.translation.y, -far, far) &&
           within(own.translation.z, -far, far),
       at.at("translation"), "numbers of at most 1e9", faults);
  must(squared > 0 && std::isfinite(squared), at.at("rotation"), "a quaternion of some length",
       faults);
  must(within(own.scale.x, -far, far) && within(own.scale.y, -far, far) &&
           within(own.scale.z, -far, far),
       at.at("scale"), "numbers of at most 1e9", faults);
}

}  // namespace

void check_material(const ModelMaterial& m, std::size_t textures, const Place& at, Faults& faults) {
  for (const double share : {m.alpha, m.metallic, m.roughness, m.occlusion, m.transmission,
                             m.clearcoat, m.clearcoat_roughness, m.sheen_roughness, m.anisotropy,
                             m.alpha_cutoff > 1 ? 1 : m.alpha_cutoff, m.specular})
    must(within(share, 0, 1), at, "numbers from 0 to 1", faults);
  must(within(m.base_color, 1) && within(m.emissive, 1) && within(m.attenuation_color, 1) &&
           within(m.sheen_color, 1) && within(m.specular_color, bright),
       at, "linear RGB", faults);
  must(within(m.emissive_strength, 0, bright) && within(m.ior, 1, 10) &&
           within(m.dispersion, 0, 10) && within(m.anisotropy_rotation, -1e3, 1e3),
       at, "numbers of principled's ranges", faults);
  must(!m.attenuation_distance || (*m.attenuation_distance > 0 && *m.attenuation_distance <= far),
       at.at("attenuation_distance"), "a number above 0", faults);
  must(m.alpha_mode <= AlphaMode::blend, at.at("alpha_mode"), "opaque, mask or blend", faults);
  for (const MaybeTexture* each :
       {&m.base_color_texture, &m.metallic_roughness_texture, &m.normal_texture,
        &m.occlusion_texture, &m.emissive_texture, &m.specular_texture, &m.specular_color_texture,
        &m.transmission_texture, &m.clearcoat_texture, &m.clearcoat_roughness_texture,
        &m.clearcoat_normal_texture, &m.sheen_color_texture, &m.sheen_roughness_texture,
        &m.anisotropy_texture, &m.metallic_texture, &m.roughness_texture, &m.alpha_texture})
    check_use(*each, textures, at, faults);
}

void check_camera(const ModelCamera& camera, const Place& at, Faults& faults) {
  if (camera.orthographic)
    must(camera.xmag != 0 && camera.ymag != 0 && within(camera.xmag, -far, far) &&
             within(camera.ymag, -far, far),
         at, "half widths that are not 0", faults);
  else
    must(camera.yfov > 0 && camera.yfov < 3.1415926535, at.at("yfov"), "an angle between 0 and pi",
         faults);
  must(!camera.aspect_ratio || (*camera.aspect_ratio > 0 && *camera.aspect_ratio < far),
       at.at("aspect_ratio"), "a number above 0", faults);
}

void check_light(const ModelLight& light, const Place& at, Faults& faults) {
  must(light.kind <= ModelLightKind::spot, at, "directional, point or spot", faults);
  must(within(light.color, bright) && light.intensity >= 0 && std::isfinite(light.intensity), at,
       "a colour and an intensity that are not below 0", faults);
  must(light.inner_angle >= 0 && light.inner_angle < light.outer_angle &&
           light.outer_angle <= 1.5707963267948970,
       at, "an inner angle below the outer one, which is pi / 2 at most", faults);
}

void check_part(const ModelPart& part, const Place& at, Faults& faults) {
  check_sizes(part, at, faults);
  const std::size_t n = part.vertices();
  must(std::ranges::all_of(part.indices, [n](std::uint32_t i) { return i < n; }), at.at("indices"),
       "numbers of vertices", faults);
  must(all_within(part.positions, far), at.at("positions"), "numbers of at most 1e9", faults);
  must(are_normals(part.normals), at.at("normals"), "normals of some length", faults);
  must(all_within(part.tangents, far) && all_within(part.uvs[0], far) &&
           all_within(part.uvs[1], far) && all_within(part.colors, bright),
       at, "finite numbers", faults);
  must(std::ranges::all_of(part.weights, [](float w) { return within(w, 0, bright); }),
       at.at("weights"), "weights that are not below 0", faults);
  for (const MorphTarget& each : part.targets)
    must(all_within(each.positions, far) && all_within(each.normals, far) &&
             all_within(each.tangents, far),
         at.at("targets"), "numbers of at most 1e9", faults);
}

void check_placement(const ModelNode& node, const Place& at, Faults& faults) {
  check_place(node.placement, at, faults);
  if (node.matrix) must(all_within(*node.matrix, far), at.at("matrix"), "finite numbers", faults);
  for (std::size_t i = 0; i < node.instances.size() && !faults.full(); ++i)
    check_place(node.instances[i], at.at("instances"), faults);
}

void check_channel(const AnimationChannel& channel, std::size_t targets, const Place& at,
                   Faults& faults) {
  const bool known =
      channel.path <= AnimatedPath::weights && channel.interpolation <= Interpolation::cubic_spline;
  must(known, at, "a path and an interpolation", faults);
  const std::size_t path_size = channel.path == AnimatedPath::rotation  ? 4
                                : channel.path == AnimatedPath::weights ? targets
                                                                        : 3;
  const std::size_t each =
      channel.interpolation == Interpolation::cubic_spline ? 3 * path_size : path_size;
  must(!channel.times.empty() && channel.values.size() == each * channel.times.size(),
       at.at("values"), "as many numbers a time as its path has", faults);
  const bool ascends = std::ranges::is_sorted(channel.times, std::ranges::less_equal()) &&
                       all_within(channel.times, far);
  must(ascends && (channel.times.empty() || channel.times.front() >= 0), at.at("times"),
       "seconds from 0 on, each after the one before", faults);
  must(all_within(channel.values, far), at.at("values"), "finite numbers", faults);
}

}  // namespace tia
