// The flat form of a model: what every reader makes of its file, as lists that name each other by
// their numbers. Nothing is computed and nothing is placed: nodes keep their own transforms. Words
// and meanings are glTF 2.0's.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "core/input/fields.h"
#include "core/materials/alpha_mode.h"
#include "core/materials/wrap.h"
#include "core/math/vec3.h"

namespace tia {

/// ModelIndex: a number of something in one of the model's lists.
using ModelIndex = std::uint32_t;
using MaybeIndex = std::optional<ModelIndex>;

// ---- materials ----------------------------------------------------------------------------------

/// ModelImage: the picture's file as it came, PNG, JPEG or WebP.
struct ModelImage {
  std::string name;
  std::vector<std::uint8_t> file;
  static constexpr std::tuple members{&ModelImage::name, &ModelImage::file};
  bool operator==(const ModelImage&) const = default;
};

struct ModelTexture {
  ModelIndex image = 0;
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  bool nearest = false;  ///< else bilinear
  static constexpr std::tuple members{&ModelTexture::image, &ModelTexture::wrap_u,
                                      &ModelTexture::wrap_v, &ModelTexture::nearest};
  bool operator==(const ModelTexture&) const = default;
};

/// TextureUse: how a material looks a texture up. uv' = offset + R(rotation) (scale * uv), v
/// downward. Source: KHR_texture_transform.
struct TextureUse {
  ModelIndex texture = 0;
  std::uint32_t uv_set = 0;  ///< 0 or 1
  std::array<double, 2> offset{0, 0}, scale{1, 1};
  double rotation = 0;  ///< radians, counter-clockwise
  double strength = 1;  ///< a normal texture's scale, an occlusion texture's strength
  static constexpr std::tuple members{&TextureUse::texture,  &TextureUse::uv_set,
                                      &TextureUse::offset,   &TextureUse::scale,
                                      &TextureUse::rotation, &TextureUse::strength};
  bool operator==(const TextureUse&) const = default;
};
using MaybeTexture = std::optional<TextureUse>;

/// ModelMaterial: glTF's metallic-roughness with the extensions that Tia takes. Colours are linear
/// RGB. Defaults are those of a file that has no materials (STL, PLY, bare OBJ).
struct ModelMaterial {
  std::string name;
  Color base_color{0.8, 0.8, 0.8};
  double alpha = 1;
  double metallic = 0, roughness = 0.5, occlusion = 1;
  Color emissive{};
  double emissive_strength = 1, ior = 1.5, specular = 1;
  Color specular_color{1, 1, 1};
  double transmission = 0;
  bool thin = true;  ///< transmits without a volume
  Color attenuation_color{1, 1, 1};
  std::optional<double> attenuation_distance;
  double clearcoat = 0, clearcoat_roughness = 0;
  Color sheen_color{};
  double sheen_roughness = 0, anisotropy = 0, anisotropy_rotation = 0, dispersion = 0;
  AlphaMode alpha_mode = AlphaMode::opaque;
  double alpha_cutoff = 0.5;
  bool double_sided = true, unlit = false;
  MaybeTexture base_color_texture, metallic_roughness_texture, normal_texture, occlusion_texture,
      emissive_texture, specular_texture, specular_color_texture, transmission_texture,
      clearcoat_texture, clearcoat_roughness_texture, clearcoat_normal_texture, sheen_color_texture,
      sheen_roughness_texture, anisotropy_texture;
  /// OBJ's files keep these numbers in pictures of their own. Channel r.
  MaybeTexture metallic_texture, roughness_texture, alpha_texture;

  static constexpr std::tuple members{&ModelMaterial::name,
                                      &ModelMaterial::base_color,
                                      &ModelMaterial::alpha,
                                      &ModelMaterial::metallic,
                                      &ModelMaterial::roughness,
                                      &ModelMaterial::occlusion,
                                      &ModelMaterial::emissive,
                                      &ModelMaterial::emissive_strength,
                                      &ModelMaterial::ior,
                                      &ModelMaterial::specular,
                                      &ModelMaterial::specular_color,
                                      &ModelMaterial::transmission,
                                      &ModelMaterial::thin,
                                      &ModelMaterial::attenuation_color,
                                      &ModelMaterial::attenuation_distance,
                                      &ModelMaterial::clearcoat,
                                      &ModelMaterial::clearcoat_roughness,
                                      &ModelMaterial::sheen_color,
                                      &ModelMaterial::sheen_roughness,
                                      &ModelMaterial::anisotropy,
                                      &ModelMaterial::anisotropy_rotation,
                                      &ModelMaterial::dispersion,
                                      &ModelMaterial::alpha_mode,
                                      &ModelMaterial::alpha_cutoff,
                                      &ModelMaterial::double_sided,
                                      &ModelMaterial::unlit,
                                      &ModelMaterial::base_color_texture,
                                      &ModelMaterial::metallic_roughness_texture,
                                      &ModelMaterial::normal_texture,
                                      &ModelMaterial::occlusion_texture,
                                      &ModelMaterial::emissive_texture,
                                      &ModelMaterial::specular_texture,
                                      &ModelMaterial::specular_color_texture,
                                      &ModelMaterial::transmission_texture,
                                      &ModelMaterial::clearcoat_texture,
                                      &ModelMaterial::clearcoat_roughness_texture,
                                      &ModelMaterial::clearcoat_normal_texture,
                                      &ModelMaterial::sheen_color_texture,
                                      &ModelMaterial::sheen_roughness_texture,
                                      &ModelMaterial::anisotropy_texture,
                                      &ModelMaterial::metallic_texture,
                                      &ModelMaterial::roughness_texture,
                                      &ModelMaterial::alpha_texture};
  bool operator==(const ModelMaterial&) const = default;
};

// ---- geometry -----------------------------------------------------------------------------------

/// MorphTarget: what a weight of 1 adds. Shape: as the part's lists of these names, or empty.
struct MorphTarget {
  std::vector<float> positions, normals, tangents;  ///< three numbers a vertex
  static constexpr std::tuple members{&MorphTarget::positions, &MorphTarget::normals,
                                      &MorphTarget::tangents};
  bool operator==(const MorphTarget&) const = default;
};

/// VariantMaterial: the material that a part wears in a variant.
struct VariantMaterial {
  ModelIndex variant = 0, material = 0;
  static constexpr std::tuple members{&VariantMaterial::variant, &VariantMaterial::material};
  bool operator==(const VariantMaterial&) const = default;
};

/// ModelPart: what wears one material: a glTF primitive. Shape: of each list as many numbers a
/// vertex as said, or none; positions there are always.
/// Space/units: the mesh's own. Uvs have v downward, as glTF's, whatever the file says.
struct ModelPart {
  std::vector<double> positions;           ///< x, y, z
  std::vector<float> normals;              ///< x, y, z, of any length but 0
  std::vector<float> tangents;             ///< x, y, z and w, which is 1 or -1
  std::array<std::vector<double>, 2> uvs;  ///< u, v
  std::vector<float> colors;               ///< linear r, g, b and alpha
  std::vector<std::uint32_t> joints;       ///< 4 or 8 of the skin's joints
  std::vector<float> weights;              ///< as many
  std::vector<MorphTarget> targets;
  std::vector<std::uint32_t> indices;  ///< three a triangle; of points none
  bool points = false;                 ///< whether its vertices are points
  MaybeIndex material;
  std::vector<VariantMaterial> variants;

  std::size_t vertices() const { return positions.size() / 3; }
  std::size_t triangles() const { return indices.size() / 3; }
  static constexpr std::tuple members{
      &ModelPart::positions, &ModelPart::normals, &ModelPart::tangents, &ModelPart::uvs,
      &ModelPart::colors,    &ModelPart::joints,  &ModelPart::weights,  &ModelPart::targets,
      &ModelPart::indices,   &ModelPart::points,  &ModelPart::material, &ModelPart::variants};
  bool operator==(const ModelPart&) const = default;
};

struct ModelMesh {
  std::string name;
  std::vector<ModelPart> parts;
  std::vector<double> weights;  ///< of the morph targets, which all its parts have alike
  static constexpr std::tuple members{&ModelMesh::name, &ModelMesh::parts, &ModelMesh::weights};
  bool operator==(const ModelMesh&) const = default;
};

// ---- the tree -----------------------------------------------------------------------------------

/// Placement: translation * rotation * scale. The rotation is a quaternion x, y, z, w of any length
/// but 0.
struct Placement {
  Vec3d translation{};
  std::array<double, 4> rotation{0, 0, 0, 1};
  Vec3d scale{1, 1, 1};
  static constexpr std::tuple members{&Placement::translation, &Placement::rotation,
                                      &Placement::scale};
  bool operator==(const Placement&) const = default;
};

/// ModelNode. Domain: each has one parent at most, and there is no circle.
struct ModelNode {
  std::string name;
  std::vector<ModelIndex> children;
  Placement placement;
  std::optional<std::array<double, 16>> matrix;  ///< instead of it; column by column
  MaybeIndex mesh, camera, light, skin;
  std::vector<double> weights;       ///< instead of the mesh's; or none
  std::vector<Placement> instances;  ///< of the mesh, each inside the node's own; none: one
  static constexpr std::tuple members{
      &ModelNode::name,    &ModelNode::children, &ModelNode::placement, &ModelNode::matrix,
      &ModelNode::mesh,    &ModelNode::camera,   &ModelNode::light,     &ModelNode::skin,
      &ModelNode::weights, &ModelNode::instances};
  bool operator==(const ModelNode&) const = default;
};

struct ModelScene {
  std::string name;
  std::vector<ModelIndex> nodes;  ///< the roots
  static constexpr std::tuple members{&ModelScene::name, &ModelScene::nodes};
  bool operator==(const ModelScene&) const = default;
};

struct ModelCamera {
  std::string name;
  bool orthographic = false;
  double yfov = 0;  ///< radians
  std::optional<double> aspect_ratio;
  double xmag = 1, ymag = 1;  ///< half of what an orthographic one sees
  static constexpr std::tuple members{&ModelCamera::name, &ModelCamera::orthographic,
                                      &ModelCamera::yfov, &ModelCamera::aspect_ratio,
                                      &ModelCamera::xmag, &ModelCamera::ymag};
  bool operator==(const ModelCamera&) const = default;
};

enum class ModelLightKind : std::uint8_t { directional, point, spot };
template <>
struct Names<ModelLightKind> {
  static constexpr std::array<std::string_view, 3> names{"directional", "point", "spot"};
};

/// ModelLight: at its node's origin, along its -z. Source: KHR_lights_punctual.
struct ModelLight {
  std::string name;
  ModelLightKind kind = ModelLightKind::point;
  Color color{1, 1, 1};
  double intensity = 1;                                      ///< candela; of a directional one lux
  double inner_angle = 0, outer_angle = 0.7853981633974483;  ///< a spot's half angles, radians
  static constexpr std::tuple members{&ModelLight::name,        &ModelLight::kind,
                                      &ModelLight::color,       &ModelLight::intensity,
                                      &ModelLight::inner_angle, &ModelLight::outer_angle};
  bool operator==(const ModelLight&) const = default;
};

// ---- motion -------------------------------------------------------------------------------------

struct ModelSkin {
  std::string name;
  std::vector<ModelIndex> joints;                     ///< nodes
  std::vector<std::array<double, 16>> inverse_binds;  ///< one a joint, column by column
  static constexpr std::tuple members{&ModelSkin::name, &ModelSkin::joints,
                                      &ModelSkin::inverse_binds};
  bool operator==(const ModelSkin&) const = default;
};

enum class AnimatedPath : std::uint8_t { translation, rotation, scale, weights };
enum class Interpolation : std::uint8_t { linear, step, cubic_spline };

/// AnimationChannel. Shape: of `values` 3, 4, 3 or as many numbers a time as the node has morph
/// targets; of a cubic spline three times so many: in-tangent, value, out-tangent.
struct AnimationChannel {
  ModelIndex node = 0;
  AnimatedPath path = AnimatedPath::translation;
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times;  ///< seconds, ascending, from 0 on
  std::vector<float> values;
  static constexpr std::tuple members{&AnimationChannel::node, &AnimationChannel::path,
                                      &AnimationChannel::interpolation, &AnimationChannel::times,
                                      &AnimationChannel::values};
  bool operator==(const AnimationChannel&) const = default;
};

struct ModelAnimation {
  std::string name;
  std::vector<AnimationChannel> channels;
  static constexpr std::tuple members{&ModelAnimation::name, &ModelAnimation::channels};
  bool operator==(const ModelAnimation&) const = default;
};

// ---- all of it ----------------------------------------------------------------------------------

/// ModelWarning: what of a file is not taken; at a JSON Pointer into it or at a line, from 1.
struct ModelWarning {
  std::string pointer;
  std::uint64_t line = 0;  ///< 0: none
  std::string text;
  static constexpr std::tuple members{&ModelWarning::pointer, &ModelWarning::line,
                                      &ModelWarning::text};
  bool operator==(const ModelWarning&) const = default;
};

/// Model. Its up is +y, or +z where `z_up`, as with STL and PLY.
struct Model {
  static constexpr std::size_t most_warnings = 20;
  std::string format;  ///< its row's name in formats.h
  std::string generator, copyright;
  bool z_up = false;
  std::vector<ModelScene> scenes;
  ModelIndex scene = 0;  ///< the one that is shown
  std::vector<ModelNode> nodes;
  std::vector<ModelMesh> meshes;
  std::vector<ModelMaterial> materials;
  std::vector<ModelTexture> textures;
  std::vector<ModelImage> images;
  std::vector<ModelCamera> cameras;
  std::vector<ModelLight> lights;
  std::vector<ModelSkin> skins;
  std::vector<ModelAnimation> animations;
  std::vector<std::string> variants, extensions;
  std::vector<ModelWarning> warnings;  ///< the first 20

  void warn(ModelWarning warning) {
    if (warnings.size() < most_warnings) warnings.push_back(std::move(warning));
  }
  static constexpr std::tuple members{&Model::format,   &Model::generator,  &Model::copyright,
                                      &Model::z_up,     &Model::scenes,     &Model::scene,
                                      &Model::nodes,    &Model::meshes,     &Model::materials,
                                      &Model::textures, &Model::images,     &Model::cameras,
                                      &Model::lights,   &Model::skins,      &Model::animations,
                                      &Model::variants, &Model::extensions, &Model::warnings};
  bool operator==(const Model&) const = default;
};

}  // namespace tia
