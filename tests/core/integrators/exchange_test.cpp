// What surfaces send to each other in path, by closed forms.
#include "tests/core/integrators/paths.h"

namespace tia {
namespace {

using namespace test;

// ---------------------------------------------------------------------

// Two parallel planes that shine by themselves: light of the first, the second, the first ... wall,
// each the albedo of those before it darker.
TEST(Exchange, OfParallelPlanesIsASumByBounces) {
  Random random(830);
  for (int depth = 0; depth < 6; ++depth) {
    const Onb frame = onb_around(random.direction());
    const double gap = random.in(0.5, 4);
    const std::array albedo{random.in(0.2, 0.9), random.in(0.2, 0.9)};
    const std::array light{random.in(0.1, 2), random.in(0.1, 2)};
    Scene scene;
    for (std::size_t i = 0; i < 2; ++i) {
      Finish finish = matt(albedo[i]);
      finish.emission = {light[i], light[i], light[i]};
      const double turned = i == 0 ? 1 : -1;
      scene.objects.push_back(
          object(Plane{frame.n * (i == 0 ? 0 : gap), frame.n * turned}, finish));
    }
    double expected = 0, left = 1;
    for (int k = 0; k <= depth; ++k) {
      const auto wall = static_cast<std::size_t>(k % 2);
      expected += left * light[wall];
      left *= albedo[wall];
    }
    const Mean mean = light_from(scene, frame.n * (gap / 2) + frame.u, {0, 0, 0}, 64, depth);
    expect_mean(mean, expected, 1e-4);
  }
}

// A point light of intensity I at h between floor and ceiling H: below it the floor gets I / h^2,
// and of what the ceiling gets at r, I g / (r^2 + g^2)^1.5 with g = H - h, the albedo's share over
// pi, from all of it by H^2 / (r^2 + H^2)^2. With s^2 = r^2 + g^2 and k^2 = H^2 - g^2 that is
// 2 a I g H^2 times the integral from g on of ds / (s^2 (s^2 + k^2)^2), by partial fractions.
TEST(Exchange, OfACeilingOverALampIsItsIntegral) {
  Random random(831);
  for (int i = 0; i < rounds(4, 4); ++i) {
    LitFloor floor(random);
    const double high = random.in(1, 3), h = high * random.in(0.3, 0.8), g = high - h;
    const double albedo = random.in(0.3, 1), intensity = random.in(1, 9);
    floor.scene.objects.push_back(
        object(Plane{floor.frame.n * high, -floor.frame.n}, matt(albedo)));
    floor.scene.lights = {point_light(floor.frame.n * h)};
    floor.scene.lights[0].intensity = intensity;
    const double k_2 = high * high - g * g, k = std::sqrt(k_2), angle = pi / 2 - std::atan(g / k);
    const double integral = 1 / (k_2 * k_2 * g) - angle / (k_2 * k_2 * k) -
                            (angle / (2 * k_2 * k) - g / (2 * k_2 * high * high)) / k_2;
    const double direct = intensity / (h * h);
    const double once = 2 * albedo * intensity * g * high * high * integral;
    expect_mean(floor.irradiance(4, 1), direct, 1e-4);
    expect_mean(floor.irradiance(1024, 2), direct + once, 1e-4);
  }
}

// In an integrating sphere all that is scattered, wherever from, lights each point of the wall
// alike: E = direct + Phi a / (4 pi R^2 (1 - a)).
// Source: Jacquez, Kuppenheim, "Theory of the integrating sphere", JOSA 45 (1955).
TEST(Exchange, OfAnIntegratingSphereIsEvenWhereverTheLampIs) {
  Random random(825);
  for (int i = 0; i < rounds(4, 4); ++i) {
    const double radius = random.in(1, 3), albedo = random.in(0.3, 0.8);
    Scene scene;
    scene.objects = {object(Sphere{{0, 0, 0}, radius}, matt(albedo))};
    const Vec3d light = random.point(0.5 * radius);
    scene.lights = {point_light(light)};
    const Vec3d wall = random.direction() * radius, to = light - wall;
    const double direct = dot(normalize(to), normalize(wall) * -1.0) / dot(to, to);
    const double spread = albedo / (radius * radius * (1 - albedo));
    expect_mean(light_from(scene, {0, 0, 0}, wall, 1024, 64), albedo / pi * (direct + spread));
  }
}

}  // namespace
}  // namespace tia
