// The coats and the grain of models, which lie as their maps and their uvs say: in light from one
// direction, of which path leaves nothing to chance.
#include <gtest/gtest.h>

#include "tests/core/scene/textured_models.h"
#include "tests/core/tree.h"

namespace tia {
namespace {

using namespace test;

using Code = std::array<std::uint8_t, 4>;
constexpr Code tilted_code{178, 102, 230, 255}, steep_code{250, 128, 160, 255};
const Vec3d straight_up{0, 0, 1};

Vec3d normal_said_by(const Code& code, double strength = 1) {
  const auto signed_code = [](int of) { return 2 * of / 255.0 - 1; };
  return normalize(Vec3d{signed_code(code[0]) * strength, signed_code(code[1]) * strength,
                         signed_code(code[2])});
}
TextureUse use_of(ModelIndex texture, double strength = 1) {
  TextureUse use;
  use.texture = texture;
  use.strength = strength;
  return use;
}
// What the camera at z = 5 (or -5) sees of the square in light from there.
Vec3d seen_in(const Vec3d& to_light, const Model& model, const std::vector<ImageRgba8>& images,
              bool from_behind = false) {
  Scene scene = square_scene(source_of(model, images));
  if (from_behind) scene.camera.location.z = -5, scene.camera.direction = Vec3d{0, 0, 1};
  DirectionalLight sun;
  sun.direction = -to_light;
  scene.lights = {light_of(sun)};
  const Image wide = drawn(scene, IntegratorName::path, 3, 3);
  EXPECT_EQ(wide.rgb, drawn(scene, IntegratorName::path, 3, 3, Scalar::narrow).rgb);
  const float* rgb = wide.at(1, 1);
  return {rgb[0], rgb[1], rgb[2]};
}

// ---- coats --------------------------------------------------------------------------------------

constexpr double coat_alpha = 0.16;
// A coat over nothing.
Model coated_square(std::size_t images) {
  Model model = square_model(images);
  ModelMaterial& paint = paint_of(model);
  paint.base_color = {0, 0, 0};
  paint.specular = 0;
  paint.clearcoat = 1, paint.clearcoat_roughness = 0.4;
  return model;
}
// Source: Khronos, glTF 2.0, B.3: F D V and the cosine, all at the coat's own normal n.
double coat_at(const Vec3d& n, const Vec3d& wo, const Vec3d& wi) {
  const double a2 = coat_alpha * coat_alpha, nl = dot(n, wi), nv = dot(n, wo);
  if (!(nl > 0)) return 0;
  const Vec3d h = normalize(wo + wi);
  const double t = dot(n, h) * dot(n, h) * (a2 - 1) + 1;
  const double d = a2 / (pi * t * t);
  const double v =
      0.5 / (nl * std::sqrt(nv * nv * (1 - a2) + a2) + nv * std::sqrt(nl * nl * (1 - a2) + a2));
  return (0.04 + 0.96 * std::pow(1 - dot(wo, h), 5)) * d * v * nl;
}
void expect_coat(const Model& model, const std::vector<ImageRgba8>& images, const Vec3d& n,
                 const char* law) {
  Random random(2290);
  for (int i = 0; i < 6; ++i) {
    const Vec3d wi = normalize(Vec3d{random.in(-1, 1), random.in(-1, 1), random.in(0.2, 1)});
    const double expected = coat_at(n, straight_up, wi);
    const Vec3d got = seen_in(wi, model, images);
    EXPECT_NEAR(got.y, expected, 1e-3 * expected + 1e-6) << law << ' ' << i;
  }
}

TEST(ModelCoats, ShineByTheirOwnNormals) {
  const auto images = std::vector{even_rgba(2, 2, tilted_code), even_rgba(2, 2, steep_code)};
  Model model = coated_square(2);
  expect_coat(model, images, straight_up, "without a map");
  paint_of(model).clearcoat_normal_texture = use_of(0);
  expect_coat(model, images, normal_said_by(tilted_code), "with one");
  paint_of(model).clearcoat_normal_texture = use_of(0, 0.5);
  expect_coat(model, images, normal_said_by(tilted_code, 0.5), "by its scale");
  paint_of(model).normal_texture = use_of(1);
  expect_coat(model, images, normal_said_by(tilted_code, 0.5), "over what is bent otherwise");
  paint_of(model).clearcoat_normal_texture.reset();
  expect_coat(model, images, straight_up, "that a normal map of what it covers leaves as it is");
}

TEST(ModelCoats, FlatMapsChangeNoByte) {
  Random random(2291);
  const auto images = std::vector{even_rgba(2, 2, tilted_code), even_rgba(2, 2, steep_code)};
  for (const bool bent : {false, true}) {
    Model plain = coated_square(2);
    paint_of(plain).base_color = {0.5, 0.6, 0.7}, paint_of(plain).specular = 1;
    if (bent) paint_of(plain).normal_texture = use_of(1);
    Model mapped = plain, tilted = plain;
    paint_of(mapped).clearcoat_normal_texture = use_of(0, 0);
    paint_of(tilted).clearcoat_normal_texture = use_of(0);
    for (int i = 0; i < 5; ++i) {
      const Vec3d wi = normalize(Vec3d{random.in(-1, 1), random.in(-1, 1), random.in(0.3, 1)});
      EXPECT_EQ(seen_in(wi, mapped, images), seen_in(wi, plain, images));
      EXPECT_NE(seen_in(wi, tilted, images), seen_in(wi, plain, images));
    }
  }
}

TEST(ModelCoats, OfTheBackAndOfMirroredNodesAreTheMirrorImage) {
  const auto images = std::vector{even_rgba(2, 2, tilted_code)};
  const Vec3d wi = normalize(Vec3d{0.4, 0.3, 0.8});
  Model model = coated_square(1);
  paint_of(model).clearcoat_normal_texture = use_of(0);
  const Vec3d usual = seen_in(wi, model, images);
  // From behind the slopes are the same, and so is what is seen of them from the other side.
  EXPECT_NEAR(seen_in({-wi.x, -wi.y, -wi.z}, model, images, true).y,
              coat_at(normal_said_by(tilted_code), straight_up, wi), 1e-3 * usual.y);
  model.nodes[0].placement.scale = {-1, 1, 1};
  model.nodes[0].placement.translation = {1, 0, 0};
  EXPECT_NEAR(seen_in({-wi.x, wi.y, wi.z}, model, images).y, usual.y, 1e-4 * usual.y);
}

// ---- grain --------------------------------------------------------------------------------------

Model brushed_square(double turn = 0) {
  Model model = square_model(1);
  ModelMaterial& paint = paint_of(model);
  paint.base_color = {0.9, 0.7, 0.5};
  paint.metallic = 1, paint.roughness = 0.4;
  paint.anisotropy = 0.8, paint.anisotropy_rotation = turn;
  return model;
}
Vec3d turned_about_z(const Vec3d& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}
const std::vector<ImageRgba8> no_grain{even_rgba(2, 2, {0, 0, 0, 255})};
void expect_alike(const Vec3d& got, const Vec3d& expected, const char* law) {
  EXPECT_LE(length(got - expected), 1e-4 * length(expected))
      << law << ": " << testing::PrintToString(got) << " expected "
      << testing::PrintToString(expected);
}

TEST(ModelGrain, RunsAlongTheTangentAndTurnsWithIt) {
  Random random(2292);
  for (int i = 0; i < 5; ++i) {
    const Vec3d wi = normalize(Vec3d{random.in(0.2, 1), random.in(-0.1, 0.1), 1});
    const auto seen = [&](const Model& model, double turned_back) {
      return seen_in(turned_about_z(wi, -turned_back), model, no_grain);
    };
    const Vec3d usual = seen(brushed_square(), 0);
    EXPECT_GT(length(seen(brushed_square(), pi / 2) - usual), 0.05 * length(usual)) << "it shows";
    const double angle = random.in(-3, 3);
    expect_alike(seen(brushed_square(angle), 0), seen(brushed_square(), angle), "a turned grain");
    Model turned = brushed_square();  // u along y
    part_of(turned).uvs[0] = {0, 0, 0, 1, 1, 1, 1, 0};
    expect_alike(seen(turned, 0), seen(brushed_square(), pi / 2), "uvs a quarter turned");
    Model told = brushed_square(angle);
    part_of(told).uvs[0].clear();
    for (int k = 0; k < 4; ++k)
      for (const float x : {0.0F, 2.0F, 0.0F, 1.0F}) part_of(told).tangents.push_back(x);
    expect_alike(seen(told, 0), seen(brushed_square(), angle + pi / 2), "tangents of the file");
    Model bare = brushed_square(angle);
    part_of(bare).uvs[0].clear();
    expect_alike(seen(bare, 0), seen(brushed_square(), angle), "without uvs from the horizontal");
    Model mirrored = brushed_square(angle);
    mirrored.nodes[0].placement.scale = {-1, 1, 1};
    mirrored.nodes[0].placement.translation = {1, 0, 0};
    expect_alike(seen_in({-wi.x, wi.y, wi.z}, mirrored, no_grain), seen(brushed_square(), angle),
                 "mirrored");
    expect_alike(seen_in({wi.x, wi.y, -wi.z}, brushed_square(angle), no_grain, true),
                 seen(brushed_square(), angle), "the same lines from behind");
  }
}

// Codes of 0 and 255 are -1 and 1: directions of 45 degrees and of 135. Blue is the strength.
TEST(ModelGrain, RunsAsItsTextureSays) {
  const Vec3d wi = normalize(Vec3d{0.6, 0.1, 1});
  for (const auto& [red, green, angle] :
       {std::tuple{255, 255, pi / 4}, std::tuple{0, 255, 3 * pi / 4}, std::tuple{0, 0, pi / 4}}) {
    const Code code{static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green), 255, 255};
    Model mapped = brushed_square(0.3);
    paint_of(mapped).anisotropy_texture = use_of(0);
    expect_alike(seen_in(wi, mapped, {even_rgba(2, 2, code)}),
                 seen_in(wi, brushed_square(angle + 0.3), no_grain), "direction");
    Model weak = brushed_square(angle + 0.3);
    paint_of(weak).anisotropy *= 51 / 255.0;
    expect_alike(seen_in(wi, mapped, {even_rgba(2, 2, {code[0], code[1], 51, 255})}),
                 seen_in(wi, weak, no_grain), "strength");
  }
}

TEST(ModelGrain, OfWhatIsNotStretchedChangesNoByte) {
  const Vec3d wi = normalize(Vec3d{0.6, 0.1, 1});
  Model plain = brushed_square();
  paint_of(plain).anisotropy_texture = use_of(0);
  const Vec3d usual = seen_in(wi, plain, {even_rgba(2, 2, {255, 128, 0, 255})});
  for (const Code& code : {Code{0, 0, 0, 255}, Code{9, 200, 0, 255}}) {
    paint_of(plain).anisotropy_rotation += 0.7;
    EXPECT_EQ(seen_in(wi, plain, {even_rgba(2, 2, code)}), usual);
  }
  Model even = brushed_square();
  paint_of(even).anisotropy = 0;
  EXPECT_EQ(seen_in(wi, even, no_grain), usual);
}

}  // namespace
}  // namespace tia
