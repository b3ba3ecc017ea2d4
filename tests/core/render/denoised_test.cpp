// Pictures that are denoised: what is traced for it, and what it does to the noise of integrators.
#include <numbers>

#include "tests/core/render/chance.h"

namespace tia {
namespace {

using test::bits_of;
using test::chance;
using test::denoised;
using test::of_room;
using test::picture;
using test::Picture;
using test::room_of_chance;
using test::square_between;
using test::with_budget;

TEST(RenderDenoised, IsTheSameForScalarsThreadsTilesAndBudgets) {
  const Picture drawn = of_room(denoised(chance(32)));
  EXPECT_NE(bits_of(drawn.image), bits_of(of_room(chance(32)).image));
  RenderOptions other = denoised(chance(32));
  other.scalar = Scalar::narrow, other.threads = 3, other.tile = 8;
  EXPECT_EQ(bits_of(of_room(other).image), bits_of(drawn.image));
  // Halves are the same by any rounds.
  const Picture rounds = of_room(denoised(chance(32, 1e-6)));
  const Picture stopped =
      of_room(with_budget(denoised(chance(64)), {.max_rays = rounds.rays.all()}));
  EXPECT_EQ(stopped.reached->samples, 32);
  EXPECT_EQ(bits_of(stopped.image), bits_of(rounds.image));
}

TEST(RenderDenoised, WindowIsThePicturesPart) {
  constexpr int w = 130, h = 40;
  const Scene scene = room_of_chance();
  const World world = compile(scene);
  const View view = view_of(scene.camera, w, h);
  const RenderOptions options = denoised(chance(2));
  const Image all = picture(world, view, {0, 0, w, h}, options).image;
  const Window window{45, 10, 60, 30};
  const Image part = picture(world, view, window, options).image;
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x)
      for (int c = 0; c < 3; ++c)
        ASSERT_EQ(part.at(x - window.x0, y - window.y0)[c], all.at(x, y)[c]) << x << ' ' << y;
}

TEST(RenderDenoised, IsNearerToThePictureOfManySamples) {
  for (const auto integrator : {IntegratorName::ambient_occlusion, IntegratorName::path}) {
    RenderOptions options = chance(8);
    options.integrator = integrator;
    const Image noisy = of_room(options).image, image = of_room(denoised(options)).image;
    options.samples = test::rounds(512, 2);
    const Image many = of_room(options).image;
    EXPECT_LT(square_between(image, many), square_between(noisy, many)) << int(integrator);
  }
}

// A white floor under a square lamp, seen from between them, so that light is E / pi.
// Source: Howell, "A catalog of radiation heat transfer configuration factors", a differential
// element parallel to a rectangle, from above its corner; a point's is the sum over four.
double corner_factor(double a, double b, double h) {
  const double x = a / h, y = b / h, u = std::sqrt(1 + x * x), v = std::sqrt(1 + y * y);
  return (x / u * std::atan(y / u) + y / v * std::atan(x / v)) / (2 * std::numbers::pi);
}
TEST(RenderDenoised, CutsTheErrorOfTheExactFieldUnderASquareLight) {
  constexpr int size = 64;
  const Scene scene = read_scene(R"({
      "camera": {"location": [0, 0.5, 0], "look_at": [0, 0, 0], "up": [0, 0, -1],
                 "projection": "orthographic", "height": 3},
      "objects": [{"type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0],
                   "material": {"color": [1, 1, 1], "diffuse": 1}}],
      "lights": [{"type": "quad", "corner": [-0.5, 0.6, -0.5], "u": [1, 0, 0], "v": [0, 0, 1]}]})");
  for (const int samples : {4, 16}) {
    RenderOptions options = chance(samples);
    options.max_depth = 1;
    const Image noisy = picture(scene, size, size, options).image;
    const Image image = picture(scene, size, size, denoised(options)).image;
    double before = 0, after = 0, mean = 0, mean_before = 0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const double px = (x + 0.5) / size * 3 - 1.5, py = (y + 0.5) / size * 3 - 1.5;
        const auto corner = [&](double sx, double sy) {
          const double a = 0.5 + sx * px, b = 0.5 + sy * py;
          return corner_factor(a, b, 0.6);
        };
        const double exact = corner(1, 1) + corner(1, -1) + corner(-1, 1) + corner(-1, -1);
        before += std::pow(static_cast<double>(noisy.at(x, y)[0]) - exact, 2);
        after += std::pow(static_cast<double>(image.at(x, y)[0]) - exact, 2);
        mean_before += static_cast<double>(noisy.at(x, y)[0]);
        mean += static_cast<double>(image.at(x, y)[0]);
      }
    EXPECT_LT(after * (samples == 4 ? 4 : 3), before) << samples << ' ' << before / after;
    EXPECT_NEAR(mean, mean_before, 0.005 * mean_before) << samples;
  }
}

// The shadow of a ball from a point of light: within a pixel of its edge, all contrast is there.
TEST(RenderDenoised, KeepsAHardShadowsEdge) {
  const Scene scene = read_scene(R"({
      "camera": {"location": [0, 5, 0], "look_at": [0, 0, 0], "up": [0, 0, -1],
                 "projection": "orthographic", "height": 4},
      "objects": [{"type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0],
                   "material": {"color": [0.5, 0.5, 0.5], "diffuse": 1}},
                  {"type": "box", "min": [-9, 0.5, -9], "max": [0, 0.6, 9],
                   "material": {"color": [0, 0, 0]}}],
      "lights": [{"type": "point", "position": [-1.5, 8, 0], "intensity": 40},
                 {"type": "sky", "color": [0.02, 0.02, 0.02]}]})");
  constexpr int w = 64, h = 40;
  const auto column = [](const Image& of, int x) {
    double sum = 0;
    for (int y = 0; y < h; ++y) sum += static_cast<double>(of.at(x, y)[1]);
    return sum;
  };
  // The shadow ends 0.12 beyond the box' edge, which stands in the middle: in the second column.
  const int edge = w / 2 + 1;
  for (const auto integrator : {IntegratorName::path, IntegratorName::whitted}) {
    RenderOptions options = chance(8);
    options.integrator = integrator;
    options.max_depth = 2;
    const Image noisy = picture(scene, w, h, options).image;
    const Image image = picture(scene, w, h, denoised(options)).image;
    const double before = column(noisy, edge + 1) - column(noisy, edge - 1);
    const double after = column(image, edge + 1) - column(image, edge - 1);
    EXPECT_GT(after, 0.95 * before);
    EXPECT_LT(after, 1.05 * before);
  }
}

}  // namespace
}  // namespace tia
