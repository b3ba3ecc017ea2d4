// Cameras by intrinsics, by the definition of their pixels' directions, and their near and far.
#include "core/scene/pinhole.h"

#include <gtest/gtest.h>

#include "core/input/codec.h"
#include "core/scene/view.h"
#include "tests/core/faults.h"
#include "tests/core/random_scene.h"

namespace tia {
namespace {

using test::Random;

struct RandomPinhole {
  Camera frame;
  Vec3d u, v, w;
  Pinhole pinhole;
  int width, height;

  explicit RandomPinhole(Random& random)
      : w(random.direction()), width(1 + random.below(900)), height(1 + random.below(700)) {
    u = normalize(cross(random.direction(), w));
    v = cross(w, u);
    frame.location = random.point(9);
    frame.direction = w * -random.in(0.1, 9);
    frame.up = v * random.in(0.1, 9) + w * random.in(-1, 1);
    pinhole = {random.in(0.2, 3) * width, random.in(0.2, 3) * height, random.in(-0.5, 1.5) * width,
               random.in(-0.5, 1.5) * height};
  }
  Vec3d way(int i, int j) const {
    return u * ((i + 0.5 - pinhole.center_x) / pinhole.focal_x) +
           v * ((pinhole.center_y - j - 0.5) / pinhole.focal_y) - w;
  }
};

TEST(Pinhole, PixelsLookWhereItsFormulaSays) {
  Random random(310);
  for (int k = 0; k < 300; ++k) {
    const RandomPinhole is(random);
    const Camera camera = seen_through(is.pinhole, is.frame, is.width, is.height);
    Faults faults;
    camera.check({}, faults);
    ASSERT_TRUE(faults.empty());
    const View view = view_of(camera, is.width, is.height);
    EXPECT_LT(length(view.axis + is.w), 1e-12);
    for (int n = 0; n < 5; ++n) {
      const int i = random.below(is.width), j = random.below(is.height);
      const Ray<double> ray = view.ray<double>(i, j);
      EXPECT_EQ(ray.origin, is.frame.location);
      EXPECT_LT(length(ray.direction - normalize(is.way(i, j))), 1e-12);
      const auto single = view.ray<float>(static_cast<float>(i), static_cast<float>(j));
      EXPECT_LT(length(widen(single.direction) - normalize(is.way(i, j))), 1e-6);
    }
  }
}

TEST(Camera, ItsAxisIsPerpendicularToThePictureInEverySpelling) {
  Random random(311);
  for (int k = 0; k < 200; ++k) {
    Camera camera;
    camera.direction = random.vector(0.1, 9);
    camera.up = random.vector(0.1, 9);
    if (k % 2 == 0) camera.right = random.vector(0.1, 9);
    Faults faults;
    camera.check({}, faults);
    if (!faults.empty()) continue;
    const View view = view_of(camera, 64, 48);
    EXPECT_NEAR(length(view.axis), 1, 1e-12);
    EXPECT_NEAR(dot(view.axis, normalize(view.right)), 0, 1e-6);
    EXPECT_NEAR(dot(view.axis, normalize(view.up)), 0, 1e-6);
    EXPECT_GT(dot(view.axis, view.forward), 0);
  }
}

TEST(Camera, FarLiesBehindNear) {
  for (const auto& [text, pointer] : {std::pair(R"({"near": 2, "far": 2})", "/far"),
                                      {R"({"near": 0})", "/near"},
                                      {R"({"far": -1})", "/far"}}) {
    Faults faults;
    Camera camera;
    read_value(parse_json(text), Place{}, Spec{}, faults, camera);
    EXPECT_TRUE(faults.at(pointer)) << text;
  }
  const auto good = read_described<Camera>(parse_json(R"({"near": 1, "far": 1.5})"));
  const View view = view_of(good, 4, 3);
  EXPECT_EQ(view.near, 1);
  EXPECT_EQ(view.far, 1.5);
  EXPECT_TRUE(view.is_clipped());
  EXPECT_FALSE(view_of(Camera{}, 4, 3).is_clipped());
}

}  // namespace
}  // namespace tia
