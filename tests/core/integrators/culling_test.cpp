// Back faces of what is not double-sided: who passes them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "tests/core/integrators/alphas.h"
#include "tests/core/scene/models.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using namespace test;

// A square in the plane of that y whose front is above, or below.
Mesh square_at(double y, bool up = true) {
  Mesh mesh;
  mesh.positions.values = {-9, y, 9, 9, y, 9, 9, y, -9, -9, y, -9};
  if (up) mesh.indices.values = {0, 1, 2, 0, 2, 3};
  else mesh.indices.values = {0, 2, 1, 0, 3, 2};
  return mesh;
}
Principled one_sided(Principled p) {
  p.double_sided = false;
  return p;
}
constexpr std::array sights{IntegratorName::whitted, IntegratorName::path, IntegratorName::depth,
                            IntegratorName::object, IntegratorName::albedo};

TEST(Culling, TheCameraPassesBackFacesAlone) {
  for (const auto integrator : sights) {
    const auto seen = [&](bool up, bool double_sided) {
      Principled p = glowing({1, 1, 1});
      p.base_color = Color{0.5, 0.5, 0.5};
      p.double_sided = double_sided;
      Scene scene;
      scene.camera = camera_above(2);
      scene.objects = {wearing_principled(square_at(0, up), p),
                       wearing_principled(plane_at(-3), glowing({0.5, 0.5, 0.5}))};
      return bits_of(seen_by(scene, integrator));
    };
    EXPECT_EQ(seen(true, false), seen(true, true));
    EXPECT_EQ(seen(false, true), seen(true, true));
    EXPECT_NE(seen(false, false), seen(true, true));
  }
}

// Seen along -y, the front is the side to which twice the area, (b - a) x (c - a), has y above 0;
// of planes as steep as 1e5, to which the rays are almost parallel, too.
TEST(Culling, TheSideOfATriangleIsThatOfItsWinding) {
  Random random(31);
  int fronts = 0;
  for (int i = 0; i < 40; ++i) {
    const double steep = std::pow(10, random.in(-3, 5)), turn = random.in(-3, 3);
    Mesh mesh;
    std::vector<double>& positions = mesh.positions.values.edit();
    for (const auto& [x, z] : std::array<std::array<double, 2>, 3>{{{-9, 9}, {9, 9}, {0, -9}}})
      positions.insert(positions.end(), {x, steep * (std::cos(turn) * x + std::sin(turn) * z), z});
    const bool up = random.below(2) == 0;  // (18, 0) x (9, -18) in (x, z) turns up
    mesh.indices.values =
        up ? std::vector<std::uint32_t>{0, 1, 2} : std::vector<std::uint32_t>{0, 2, 1};
    const auto seen = [&](bool there, bool double_sided) {
      Principled p = glowing({1, 1, 1});
      p.double_sided = double_sided;
      Scene scene;
      scene.camera = camera_above(3e6);
      if (there) scene.objects = {wearing_principled(mesh, p)};
      return bits_of(seen_by(scene, IntegratorName::whitted));
    };
    EXPECT_NE(seen(true, true), seen(false, true)) << steep;
    EXPECT_EQ(seen(true, false), seen(up, true)) << steep;
    fronts += up ? 1 : 0;
  }
  EXPECT_GT(fronts, 5);
  EXPECT_LT(fronts, 35);
}

TEST(Culling, SoDoRaysOfMirrorsAndGlass) {
  for (const bool sided : {false, true})
    for (const auto integrator : {IntegratorName::whitted, IntegratorName::path}) {
      Principled back = glowing({1, 1, 1});
      back.double_sided = sided;
      Scene scene;
      scene.camera = camera_above(2);
      scene.background = {0.25, 0.25, 0.25};
      // The square's back is below, towards the mirror.
      scene.objects = {wearing_principled(square_at(4), back), object(plane_at(0), mirror(1))};
      EXPECT_NEAR(seen_by(scene, integrator).rgb[0], sided ? 1 : 0.25, 1e-6);
      // Its back is above, behind a pane without any strength of its own.
      scene.objects = {wearing_principled(square_at(-2, false), back),
                       object(Box{{-9, 0, -9}, {9, 1, 9}}, clear_glass(1))};
      EXPECT_NEAR(seen_by(scene, integrator).rgb[0], sided ? 1 : 0.25, 1e-6);
    }
}

TEST(Culling, ShadowAndBounceRaysDoNot) {
  for (const auto integrator :
       {IntegratorName::whitted, IntegratorName::path, IntegratorName::ambient_occlusion}) {
    // A floor below a square that glows, whose back it sees, and a sun that it hides.
    const auto floor = [&](bool double_sided, bool there = true) {
      Principled p = glowing({0.5, 0.5, 0.5});
      p.double_sided = double_sided;
      Scene scene;
      scene.camera = camera_above(1);
      DirectionalLight sun;
      sun.direction = {0.1, -1, 0};
      scene.lights = {light_of(sun)};
      scene.objects = {object(plane_at(0), Finish{})};
      if (there) scene.objects.push_back(wearing_principled(square_at(3), p));
      return bits_of(seen_by(scene, integrator, 4));
    };
    EXPECT_EQ(floor(false), floor(true));
    EXPECT_NE(floor(false), floor(false, false));
  }
}

TEST(Culling, WhatTransmitsHasABack) {
  Principled p;
  p.transmission = 0.5;
  Scene scene;
  scene.camera = camera_above(2);
  scene.background = {0.25, 0.5, 0.75};
  for (const auto integrator : {IntegratorName::whitted, IntegratorName::path}) {
    scene.objects = {wearing_principled(Sphere{{0, 0, 0}, 1}, p)};
    const auto usual = bits_of(seen_by(scene, integrator, 4));
    scene.objects = {wearing_principled(Sphere{{0, 0, 0}, 1}, one_sided(p))};
    EXPECT_EQ(bits_of(seen_by(scene, integrator, 4)), usual);
  }
}

// ---- of models ----------------------------------------------------------------------------------

// Its front is towards +z.
Scene model_seen_from(double z, const std::string& members, const Model& model) {
  Scene scene = resolved(read_scene(model_scene(members)), model);
  scene.camera.location = {1, 0.5, z};
  scene.camera.direction = Vec3d{0, 0, z > 0 ? -1.0 : 1.0};
  return scene;
}
bool is_seen_from(double z, const std::string& members, const Model& model) {
  RenderOptions options;
  options.integrator = IntegratorName::object;
  return picture(model_seen_from(z, members, model), 1, 1, options).image.rgb[0] > 0;
}

TEST(Culling, IsTheModelsChoice) {
  Model model = triangle_model();
  for (const bool double_sided : {false, true})
    for (const bool culling : {false, true}) {
      model.materials[0].double_sided = double_sided;
      const std::string members = culling ? "" : R"("culling":false)";
      EXPECT_TRUE(is_seen_from(5, members, model));
      EXPECT_EQ(is_seen_from(-5, members, model), double_sided || !culling);
    }
}

TEST(Culling, FrontIsWhatTurnsClockwiseWhereANodeMirrors) {
  Model model = triangle_model();
  model.materials[0].double_sided = false;
  EXPECT_TRUE(is_seen_from(5, "", model));
  model.nodes[0].placement.scale = {1, 1, -1};
  EXPECT_FALSE(is_seen_from(5, "", model));
  EXPECT_TRUE(is_seen_from(-5, "", model));
}

TEST(Culling, AnyFinishInAMaterialsPlaceHasTwoSides) {
  Model model = triangle_model();
  model.materials[0].double_sided = false;
  EXPECT_TRUE(is_seen_from(-5, R"("materials":{"paint":{"color":[1,0,0]}})", model));
  EXPECT_TRUE(is_seen_from(-5, R"("material":{"color":[1,0,0]})", model));
  EXPECT_FALSE(is_seen_from(
      -5, R"("materials":{"paint":{"type":"principled","double_sided":false}})", model));
}

}  // namespace
}  // namespace tia
