// The light of stills, by closed forms that are derived here.
#include "core/scene/still_studio.h"

#include "tests/core/integrators/paths.h"

namespace tia {
namespace {

using namespace test;

const StudioStand path_stand{{{1, 2, 3}, 0.7}, 33, {0, 0, -1}, IntegratorName::path};
StudioStand whitted_stand() {
  StudioStand stand = path_stand;
  stand.integrator = IntegratorName::whitted;
  return stand;
}
constexpr std::array all_studios{Studio::soft, Studio::neutral,   Studio::sun,
                                 Studio::dark, Studio::headlight, Studio::none};

// Lambert's formula for the square, of a radiance of 1, as the irradiance of what faces it.
double irradiance_of(const QuadLight& quad, const Vec3d& p) {
  const Vec3d corner = *quad.corner - p;
  return polygon_irradiance({corner, corner + quad.u, corner + quad.u + quad.v, corner + quad.v},
                            normalize(*quad.place() - p));
}

// Expected: what light is told to come from where.
struct Panel {
  double azimuth, elevation, distance, irradiance;
};
void expect_panels(Studio studio, const std::vector<Panel>& panels) {
  const StudioStand& stand = path_stand;
  const auto [center, r] = stand.ball;
  const StudioLight path = studio_light(studio, stand);
  const StudioLight whitted = studio_light(studio, whitted_stand());
  ASSERT_EQ(path.lights.size(), panels.size() + 1) << "and a sky";
  ASSERT_EQ(whitted.lights.size(), panels.size());
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const auto& quad = std::get<QuadLight>(path.lights[i].kind);
    const double azimuth = (stand.azimuth_degrees + panels[i].azimuth) * pi / 180;
    const double rise = panels[i].elevation * pi / 180;
    const Vec3d to{std::sin(azimuth) * std::cos(rise), std::sin(rise),
                   std::cos(azimuth) * std::cos(rise)};
    EXPECT_LT(length(*quad.place() - (center + to * (panels[i].distance * r))), 1e-12);
    EXPECT_NEAR(length(quad.u), 2 * r, 1e-12);
    EXPECT_NEAR(length(quad.v), 2 * r, 1e-12);
    EXPECT_LT(length(cross(quad.u, quad.v) * (1 / (4 * r * r)) - to), 1e-12) << "it faces C";
    const double radiance = path.lights[i].intensity;
    EXPECT_NEAR(radiance * irradiance_of(quad, center), panels[i].irradiance, 1e-12);
    EXPECT_EQ(whitted.lights[i].kind, path.lights[i].kind);
    EXPECT_DOUBLE_EQ(whitted.lights[i].intensity, panels[i].irradiance / pi);
    EXPECT_EQ(path.lights[i].color, (Color{1, 1, 1}));
  }
}
void expect_sky(Studio studio, const Color& radiance) {
  const Light sky = studio_light(studio, path_stand).lights.back();
  EXPECT_EQ(sky.type(), "sky");
  EXPECT_EQ(sky.color, radiance);
  EXPECT_EQ(sky.intensity, 1);
  EXPECT_EQ(studio_light(studio, path_stand).ambient_light, Color{});
  EXPECT_EQ(studio_light(studio, whitted_stand()).ambient_light, radiance);
}
// One that comes along a direction, the first.
void expect_along(Studio studio, const Vec3d& direction, double irradiance) {
  for (const StudioStand& stand : {path_stand, whitted_stand()}) {
    const Light light = studio_light(studio, stand).lights.front();
    const auto& along = std::get<DirectionalLight>(light.kind);
    EXPECT_LT(length(*along.direction - direction), 1e-12);
    EXPECT_DOUBLE_EQ(light.intensity,
                     stand.integrator == IntegratorName::path ? irradiance : irradiance / pi);
  }
}

TEST(Studio, PanelsGiveTheirIrradianceAtTheCentre) {
  expect_panels(Studio::soft, {{-45, 45, 3, pi}, {60, 20, 4, pi / 4}, {180, 40, 3, pi / 2}});
  expect_sky(Studio::soft, {0.3, 0.3, 0.3});
  expect_panels(Studio::dark, {{-110, 45, 3, pi}});
  expect_sky(Studio::dark, {0.02, 0.02, 0.02});
}

TEST(Studio, SunAndHeadlightComeAlongTheirDirections) {
  const double azimuth = (33 - 45) * pi / 180, rise = 50 * pi / 180;
  expect_along(Studio::sun,
               Vec3d{std::sin(azimuth) * std::cos(rise), std::sin(rise),
                     std::cos(azimuth) * std::cos(rise)} *
                   -1.0,
               0.9 * pi);
  expect_sky(Studio::sun, {0.2, 0.25, 0.35});
  expect_along(Studio::headlight, path_stand.view, pi);
  EXPECT_EQ(studio_light(Studio::headlight, path_stand).lights.size(), 1U);
}

TEST(Studio, NeutralIsASkyAloneAndNoneIsDark) {
  EXPECT_EQ(studio_light(Studio::neutral, path_stand).lights.size(), 1U);
  expect_sky(Studio::neutral, {1, 1, 1});
  EXPECT_TRUE(studio_light(Studio::neutral, whitted_stand()).lights.empty());
  EXPECT_TRUE(studio_light(Studio::none, path_stand).lights.empty());
  EXPECT_EQ(studio_light(Studio::none, whitted_stand()).ambient_light, Color{});
}

// What the camera's azimuth turns, a turn about the upright axis through C undoes.
TEST(Studio, TurnsWithTheAzimuth) {
  StudioStand turned = path_stand;
  turned.azimuth_degrees += 90;
  const auto turn = [](const Vec3d& v) { return Vec3d{v.z, v.y, -v.x}; };  // +z to +x
  for (const Studio studio : {Studio::soft, Studio::sun, Studio::dark}) {
    const std::vector<Light> before = studio_light(studio, path_stand).lights;
    const std::vector<Light> after = studio_light(studio, turned).lights;
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_EQ(before[i].intensity, after[i].intensity);
      if (const auto* quad = std::get_if<QuadLight>(&before[i].kind)) {
        const Vec3d way = *quad->place() - path_stand.ball.center;
        const Vec3d now = *after[i].place() - path_stand.ball.center;
        EXPECT_LT(length(turn(way) - now), 1e-12);
      } else if (const auto* along = std::get_if<DirectionalLight>(&before[i].kind)) {
        const auto& now = std::get<DirectionalLight>(after[i].kind);
        EXPECT_LT(length(turn(*along->direction) - *now.direction), 1e-12);
      }
    }
  }
}

// ---- what surfaces get of it --------------------------------------------------------------------

Scene lit(Studio studio, const StudioStand& stand, const Finish& finish) {
  Scene scene;
  const StudioLight light = studio_light(studio, stand);
  scene.lights = light.lights;
  scene.ambient_light = light.ambient_light;
  scene.objects = {object(Sphere{stand.ball.center, stand.ball.radius}, finish)};
  return scene;
}
Finish white() {
  Finish finish = matt(1);
  finish.ambient = 1;
  return finish;
}

// In a furnace of 1 what sends back all light is 1 all over.
TEST(Studio, AWhiteBodyIsOneInNeutralLight) {
  Random random(2210);
  for (int i = 0; i < 3; ++i) {
    const Vec3d eye = path_stand.ball.center + random.direction() * 5.0;
    const Vec3d at = path_stand.ball.center + random.point(0.2);
    expect_mean(light_from(lit(Studio::neutral, path_stand, white()), eye, at, 64, 16), 1);
    const Scene flat = lit(Studio::neutral, whitted_stand(), white());
    EXPECT_EQ(colors_from(flat, eye, at, {.integrator = IntegratorName::whitted}, 1)[0].value, 1);
  }
}

// A small white square at C that faces the key light sends back what that alone gives: E / pi.
TEST(Studio, AWhiteSquareAtTheCentreSendsBackTheKeyLight) {
  for (const StudioStand& stand : {path_stand, whitted_stand()})
    for (const auto& [studio, irradiance] :
         {std::pair(Studio::soft, pi), std::pair(Studio::sun, 0.9 * pi),
          std::pair(Studio::dark, pi), std::pair(Studio::headlight, pi)}) {
      Light key = studio_light(studio, stand).lights.front();
      const Vec3d center = stand.ball.center;
      Vec3d n = stand.view * -1.0;
      if (const auto* quad = std::get_if<QuadLight>(&key.kind)) n = *quad->place() - center;
      else n = *std::get<DirectionalLight>(key.kind).direction * -1.0;
      const Onb frame = onb_around(normalize(n));
      Scene scene;
      scene.lights = {key};
      scene.objects = {object(Disc{center, frame.n, 1e-3}, white())};
      RenderOptions options = by_paths(512, 4);
      options.integrator = stand.integrator;
      scene.ambient_light = {};
      const Vec3d eye = center + (frame.n + frame.u) * 0.3;
      expect_mean(colors_from(scene, eye, center, options, 2)[0], irradiance / pi, 1e-4);
    }
}

TEST(Studio, EveryStudioIsASoundScene) {
  for (const Studio studio : all_studios)
    for (const StudioStand& stand : {path_stand, whitted_stand()}) {
      const Scene scene = lit(studio, stand, white());
      EXPECT_EQ(read_scene(canonical_text(scene)), scene) << name_of(studio);
    }
}

}  // namespace
}  // namespace tia
