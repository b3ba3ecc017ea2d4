// Numbers of principled materials by textures, in pictures: each point looks as a material of its
// numbers does.
#include <gtest/gtest.h>

#include <array>

#include "core/film/png.h"
#include "tests/core/film/files.h"
#include "tests/core/random_scene.h"
#include "tests/core/tree.h"

namespace tia {
namespace {

using namespace test;

using Number = NumberOrTexture Principled::*;
constexpr std::array<Number, 8> numbers{
    &Principled::metallic,        &Principled::roughness, &Principled::specular,
    &Principled::transmission,    &Principled::clearcoat, &Principled::clearcoat_roughness,
    &Principled::sheen_roughness, &Principled::anisotropy};

template <class Kind>
NumberTexture texture_of(double black, double white) {
  NumberTexture texture;
  texture.kind = OfNumbers<Kind>{};
  texture.range = {black, white};
  return texture;
}
Object wearing(const Shape& shape, const Principled& principled) {
  Object is;
  is.shape = shape;
  is.material = MaterialRef(Material{principled});
  return is;
}

// A ball of a material whose every number shows, on a floor, under lights of both kinds.
Scene ball_of(const Principled& principled) {
  Scene scene;
  scene.background = {0.2, 0.3, 0.4};
  scene.camera.location = {0, 1, 5};
  scene.camera.look_at = Vec3d{0, 0, 0};
  scene.objects = {wearing(Sphere{{0, 0, 0}, 1}, principled),
                   object(Plane{{0, -1, 0}, {0, 1, 0}}, Finish{})};
  scene.lights = {point_light({3, 4, 3}, {9, 9, 9}), sphere_light({-3, 3, 1}, 0.5, {5, 5, 5})};
  return scene;
}
Principled of_all() {
  Principled p;
  p.base_color = Color{0.9, 0.6, 0.3};
  p.metallic = 0.4, p.roughness = 0.45, p.specular = 0.8, p.transmission = 0.3;
  p.clearcoat = 0.5, p.clearcoat_roughness = 0.3, p.anisotropy = 0.6;
  p.sheen_color = {0.3, 0.2, 0.4}, p.sheen_roughness = 0.5;
  return p;
}
std::vector<std::uint32_t> drawn(Scene scene, IntegratorName integrator) {
  scene.options.transparent_shadows = true;
  RenderOptions options;
  options.integrator = integrator;
  options.max_depth = 6;
  options.samples = 4;
  const int width = sanitized() ? 11 : 21, height = sanitized() ? 9 : 17;
  return bits_of(picture(scene, width, height, options).image);
}

TEST(TexturedNumbers, ConstantTextureIsTheNumberToTheByte) {
  Random random(860);
  for (const Number number : numbers) {
    Principled plain = of_all(), other = of_all(), textured = of_all();
    const double value = random.in(0.1, 0.9);
    plain.*number = value;
    other.*number = value < 0.5 ? value + 0.1 : value - 0.1;
    textured.*number = texture_of<Noise>(value, value);
    for (const IntegratorName integrator :
         {IntegratorName::path, IntegratorName::whitted, IntegratorName::albedo}) {
      const auto usual = drawn(ball_of(plain), integrator);
      EXPECT_EQ(drawn(ball_of(textured), integrator), usual);
      if (integrator == IntegratorName::path) {
        EXPECT_NE(drawn(ball_of(other), integrator), usual) << "the number does not show";
      }
    }
  }
}

TEST(TexturedNumbers, AllTogetherAreTheNumbersToo) {
  Random random(861);
  Principled plain = of_all(), textured = of_all();
  for (const Number number : numbers) {
    const double value = random.unit();
    plain.*number = value;
    textured.*number = texture_of<Checker>(value, value);
  }
  plain.texture = textured.texture = Texture{Marble{}};
  for (const IntegratorName integrator : {IntegratorName::path, IntegratorName::whitted})
    EXPECT_EQ(drawn(ball_of(textured), integrator), drawn(ball_of(plain), integrator));
}

// A floor seen from straight above, a cell of the checker in each pixel.
constexpr int cells = 8;
Scene floor_of(const Principled& principled) {
  Scene scene;
  scene.background = {0.3, 0.3, 0.3};
  scene.camera.projection = Projection::orthographic;
  scene.camera.height = cells;
  scene.camera.location = {0, 5, 0};
  scene.camera.direction = Vec3d{0, -1, 0};
  scene.camera.up = {0, 0, -1};
  scene.objects = {wearing(Plane{{0, 0, 0}, {0, 1, 0}}, principled)};
  scene.lights = {point_light({1, 3, 2}, {20, 20, 20})};
  return scene;
}
Image seen(const Scene& scene, IntegratorName integrator, int samples = 1) {
  RenderOptions options;
  options.integrator = integrator;
  options.max_depth = 4;
  options.samples = samples;
  return picture(scene, cells, cells, options).image;
}

TEST(TexturedNumbers, CellsOfACheckerAreAsTheirOwnMaterials) {
  Principled textured = of_all();
  textured.roughness = texture_of<Checker>(0.2, 0.7);
  Principled black = of_all(), white = of_all();
  black.roughness = 0.2, white.roughness = 0.7;
  const auto path = IntegratorName::path;
  const Image both = seen(floor_of(textured), path, 16);
  const std::array alone{seen(floor_of(white), path, 16), seen(floor_of(black), path, 16)};
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x)
      for (int k = 0; k < 3; ++k) {
        const auto parity = static_cast<std::size_t>((x + y) % 2);
        EXPECT_EQ(both.at(x, y)[k], alone[parity].at(x, y)[k]) << x << ' ' << y;
        EXPECT_NE(both.at(x, y)[k], alone[1 - parity].at(x, y)[k]) << x << ' ' << y;
      }
}

// Roughness in green, metallic in blue. As whitted has it, what is no metal is matt, and a metal
// as far as it is rough.
TEST(TexturedNumbers, OnePictureTellsRoughnessAndMetallicAsInGltf) {
  Random random(862);
  Image8 image(cells, cells);
  for (auto& code : image.rgb) code = static_cast<std::uint8_t>(random.below(256));
  NumberTexture metallic = read_described<NumberTexture>(
      parse_json(R"({"type":"image","filter":"nearest","channel":"b","range":[0,1],"data":")" +
                 base64(encode_png(image)) + "\"}"));
  NumberTexture roughness = metallic;
  roughness.channel = Channel::g;
  Principled principled;
  principled.metallic = metallic, principled.roughness = roughness;
  Scene scene = floor_of(principled);
  Mesh mesh;
  const double far = cells / 2.0;
  mesh.positions.values = {-far, 0, far, far, 0, far, far, 0, -far, -far, 0, -far};
  mesh.indices.values = {0, 1, 2, 0, 2, 3};
  mesh.uvs.values = {0, 0, 1, 0, 1, 1, 0, 1};
  scene.objects[0].shape = mesh;
  const Image albedo = seen(scene, IntegratorName::albedo);
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      const auto* code =
          &image.rgb[3 * (static_cast<std::size_t>(y) * cells + static_cast<std::size_t>(x))];
      const double rough = code[1] / 255.0, metal = code[2] / 255.0;
      EXPECT_NEAR(albedo.at(x, y)[0], 1 - metal + metal * rough, 1e-6) << x << ' ' << y;
    }
}

// A pane over the floor, transmission 1 in every other cell.
TEST(TexturedNumbers, TransparentShadowsPassWhereGlassIs) {
  Scene scene = floor_of({});
  Principled pane;
  pane.thin = true;
  pane.transmission = texture_of<Checker>(0, 1);
  scene.objects.push_back(wearing(Plane{{0, 2.5, 0}, {0, 1, 0}}, pane));
  scene.camera.location.y = 2;
  scene.options.transparent_shadows = true;
  DirectionalLight sun;
  sun.direction = {0, -1, 0};
  scene.lights = {light_of(sun)};
  const Image image = seen(scene, IntegratorName::whitted);
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      EXPECT_EQ(image.at(x, y)[0] > 0.5F, (x + y) % 2 == 0) << x << ' ' << y;
      EXPECT_EQ(image.at(x, y)[0] > 0, (x + y) % 2 == 0) << x << ' ' << y;
      const Vec3d below{x - 3.5, 1, y - 3.5};
      const auto floor = tree(scene, below, {0, -1, 0});
      EXPECT_EQ(term(*floor, TermName::diffuse)->light.blocker.has_value(), (x + y) % 2 == 1);
    }
}

// In a room of materials at random that light goes through many times.
TEST(TexturedNumbers, NeitherThreadsNorTilesNorLanesChangeAByte) {
  Random random(863);
  Scene scene = ball_of(random_principled(random));
  for (int i = 0; i < 9; ++i)
    scene.objects.push_back(
        wearing(Sphere{random.point(1.5), random.in(0.2, 0.7)}, random_principled(random)));
  scene.options.transparent_shadows = true;
  for (const IntegratorName integrator : {IntegratorName::path, IntegratorName::whitted}) {
    RenderOptions options;
    options.integrator = integrator;
    options.samples = 4;
    const auto usual = bits_of(picture(scene, 37, 29, options).image);
    options.scalar = Scalar::narrow;
    options.threads = 3, options.tile = 7;
    EXPECT_EQ(bits_of(picture(scene, 37, 29, options).image), usual);
  }
}

}  // namespace
}  // namespace tia
