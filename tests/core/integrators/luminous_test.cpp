// Luminous objects as lights of the path tracer, by closed forms.
#include "tests/core/integrators/paths.h"

namespace tia {
namespace {

using namespace test;

// Seen from afar, for a light must not hide itself from rays that start the farther off the floor.
Mean matt_floor(const std::vector<Object>& lights, const Onb& frame, int samples) {
  Scene scene;
  scene.objects = lights;
  scene.objects.push_back(object(Plane{{0, 0, 0}, frame.n}, matt(0.7)));
  return light_from(scene, frame.n * 2.0 - frame.u * 12.0, {0, 0, 0}, samples, 1);
}

TEST(Luminous, TriangleIsLambertsFormula) {
  Random random(960);
  for (int i = 0; i < rounds(4, 1); ++i) {
    const Onb frame = onb_around(random.direction());
    const Vec3d a = frame.n * random.in(1, 2) + frame.u * random.in(-1, 1);
    const Vec3d b = a + frame.u * random.in(0.2, 1) + frame.n * random.in(0, 0.5);
    const Vec3d c = a + frame.v * random.in(-1, 1) + frame.n * random.in(0, 1);
    const double expected = 0.7 / pi * 2 * polygon_irradiance({a, b, c}, frame.n);
    expect_mean(matt_floor({object(Triangle{a, b, c}, glowing(2))}, frame, 256), expected);
    // As a mesh of two, with its halves parted along an edge.
    const Vec3d m = (b + c) * 0.5;
    expect_mean(
        matt_floor({object(mesh_of({a, b, m, c}, {0, 1, 2, 0, 2, 3}), glowing(2))}, frame, 256),
        expected, 1e-4);
  }
}

// Source: Howell, "A catalog of radiation heat transfer configuration factors", B-13: on the axis
// E = pi L r^2 / (r^2 + h^2).
TEST(Luminous, DiscOnItsAxisIsItsFormFactor) {
  Random random(961);
  for (int i = 0; i < rounds(4, 1); ++i) {
    const Onb frame = onb_around(random.direction());
    const double h = random.in(0.5, 2), r = random.in(0.2, 1.5);
    const Object disc = object(Disc{frame.n * h, frame.n, r}, glowing(3));
    expect_mean(matt_floor({disc}, frame, 512), 0.7 * 3 * r * r / (r * r + h * h));
  }
}

// Of a box above the floor the lower face is seen, and aside of it others, each Lambert's.
TEST(Luminous, BoxIsTheSumOfTheFacesThatAreSeen) {
  Random random(962);
  const Onb up{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  for (int i = 0; i < rounds(4, 1); ++i) {
    const Vec3d low{random.in(0.2, 1), random.in(0.5, 2), random.in(-0.5, 0.2)};
    const Vec3d high = low + Vec3d{random.in(0.2, 1), random.in(0.2, 1), random.in(0.6, 1)};
    const double bottom = polygon_irradiance(
        {low, {high.x, low.y, low.z}, {high.x, low.y, high.z}, {low.x, low.y, high.z}}, {0, 1, 0});
    const double side = polygon_irradiance(
        {low, {low.x, high.y, low.z}, {low.x, high.y, high.z}, {low.x, low.y, high.z}}, {0, 1, 0});
    const double front =
        low.z < 0
            ? 0
            : polygon_irradiance(
                  {low, {high.x, low.y, low.z}, {high.x, high.y, low.z}, {low.x, high.y, low.z}},
                  {0, 1, 0});
    expect_mean(matt_floor({object(Box{low, high}, glowing(1))}, up, 256),
                0.7 / pi * (bottom + side + front));
  }
}

// What has a sampler against the same light found by the surface's directions alone, behind a pane
// of clear glass that hides it from questions.
TEST(Luminous, AskedForOrFoundIsTheSame) {
  Random random(963);
  for (int i = 0; i < rounds(2, 1); ++i) {
    const Onb frame = onb_around(random.direction());
    const Vec3d p = frame.n * 1.4 + frame.u * random.in(-1, 1);
    const std::vector<Object> lights{
        object(Cylinder{p, p + random.direction() * 0.8, 0.4}, glowing(1)),
        object(Sphere{p + frame.v * 1.5, 0.5}, glowing(2)),
        object(Box{{-0.1, -0.2, -0.3}, {0.2, 0.3, 0.1}}, glowing(5)),
        object(Disc{p - frame.v * 1.5, random.direction(), 0.6}, glowing(3)),
        object(Triangle{p + frame.u, p + frame.u * 2.0, p + frame.u + frame.n}, glowing(4)),
        object(Capsule{p - frame.u * 2.0, p - frame.u * 2.5, 0.3}, glowing(1))};
    std::vector<Object> moved = lights;
    moved[2].transform.steps.push_back(Translate{p - frame.v * 3.0});
    const Mean asked = matt_floor(moved, frame, 1024);
    moved.push_back(object(Sphere{{0, 0, 0}, 0.25}, clear_glass(1)));
    Scene scene;
    scene.objects = moved;
    scene.objects.push_back(object(Plane{{0, 0, 0}, frame.n}, matt(0.7)));
    const Mean found = light_from(scene, frame.n * 0.1, {0, 0, 0}, 8192, 3);
    expect_equal(found, asked, 1e-4);
  }
}

// Copies of one lamp are lights each.
TEST(Luminous, CopiesShineLikeLamps) {
  Group group;
  group.children = {object(Sphere{{0, 3, 0}, 0.1}, glowing(10))};
  group.repeat = Repeat{{3, 1, 3}, {1, 1, 1}};
  Object lamps;
  lamps.shape = group;
  std::vector<Object> single;
  for (int x = 0; x < 3; ++x)
    for (int z = 0; z < 3; ++z)
      single.push_back(object(Sphere{{double(x), 3, double(z)}, 0.1}, glowing(10)));
  const Onb up{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  double expected = 0;  // pi L (r / d)^2 cos
  for (const Object& lamp : single) {
    const Vec3d to = std::get<Sphere>(lamp.shape).center;
    expected += 0.7 * 10 * 0.01 / dot(to, to) * to.y / length(to);
  }
  expect_mean(matt_floor({lamps}, up, 256), expected);
  expect_mean(matt_floor(single, up, 256), expected);
}

}  // namespace
}  // namespace tia
