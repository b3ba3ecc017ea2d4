// Whole pictures against an independent tracer.
#include <gtest/gtest.h>

#include "tests/core/random_scene.h"
#include "tests/core/reference.h"

namespace tia {
namespace {

using test::picture;
using test::Reference;

int code(double light) { return static_cast<int>(255 * std::clamp(light, 0.0, 1.0) + 0.5); }

RenderOptions in(Scalar scalar) {
  RenderOptions options;
  options.scalar = scalar;
  return options;
}

struct Difference {
  int edges = 0;     // pixels not compared
  int levels = 0;    // most 8-bit levels
  double light = 0;  // most linear light
  Vec3d brightest{};
};

Difference difference(const Reference& reference, const Image& image) {
  Difference found;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (reference.on_edge(x, y)) {
        ++found.edges;
        continue;
      }
      const Vec3d color = reference.trace(x, y).color;
      const double exact[] = {color.x, color.y, color.z};
      for (int c = 0; c < 3; ++c) {
        const double got = static_cast<double>(image.at(x, y)[c]);
        found.levels = std::max(found.levels, std::abs(code(got) - code(exact[c])));
        found.light = std::max(found.light, std::fabs(got - exact[c]));
        if (std::isnan(got)) found.levels = 256;
      }
    }
  }
  return found;
}

class EveryKey : public testing::TestWithParam<char> {};
INSTANTIATE_TEST_SUITE_P(Reference, EveryKey, testing::Values('0', 'a', 'd', 's', 'w'));

TEST_P(EveryKey, PictureAgreesWithTheReferenceWithinOneLevel) {
  const Scene scene = test::thesis_scene(GetParam() == '0' ? '\0' : GetParam());
  constexpr int width = 320, height = 240;
  const Reference reference(scene, width, height);
  for (const Scalar scalar : {Scalar::wide, Scalar::narrow, Scalar::exact}) {
    const Image image = picture(scene, width, height, in(scalar)).image;
    const Difference found = difference(reference, image);
    EXPECT_LE(found.levels, 1);
    // Float: roundings of p, n and l in units of 1e-7 of 30; double: stored as float.
    EXPECT_LT(found.light, scalar == Scalar::exact ? 1e-7 : 1e-5);
    EXPECT_LT(found.edges, width * height / 500) << "too few pixels compared";
  }
}

class EverySeed : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Reference, EverySeed, testing::Range(0, 32));

TEST_P(EverySeed, RandomSceneAgreesWithTheReferenceWithinOneLevel) {
  const Scene scene = test::random_scene(static_cast<std::uint64_t>(GetParam()));
  constexpr int width = 96, height = 72;
  const Reference reference(scene, width, height);
  for (const Scalar scalar : {Scalar::wide, Scalar::exact}) {
    const Difference found = difference(reference, picture(scene, width, height, in(scalar)).image);
    EXPECT_LE(found.levels, 1);
    EXPECT_LT(found.light, scalar == Scalar::exact ? 5e-7 : 1e-4);
    EXPECT_LT(found.edges, width * height / 100) << "too few pixels compared";
  }
}

// A shadow ray for each light and hit with n.l > 0, told by the reference.
struct Counted {
  RayCounts rays;
  int edges = 0;
};
Counted count_rays(const Scene& scene, int width, int height) {
  const Reference reference(scene, width, height);
  Counted counted;
  counted.rays.primary = std::int64_t{width} * height;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto story = reference.trace(x, y).story;
      for (const auto sight : story.lights)
        counted.rays.shadow += sight != Reference::Story::turned_away;
      for (const double jitter : {-1e-5, 1e-5}) {
        const auto moved = reference.trace(x + jitter, y + jitter).story;
        counted.edges += moved.ball != story.ball || moved.lights.size() != story.lights.size();
        for (std::size_t i = 0; i < std::min(moved.lights.size(), story.lights.size()); ++i)
          counted.edges += (moved.lights[i] == Reference::Story::turned_away) !=
                           (story.lights[i] == Reference::Story::turned_away);
      }
    }
  }
  return counted;
}

TEST_P(EveryKey, RayCountsAreExact) {
  const Scene scene = test::thesis_scene(GetParam() == '0' ? '\0' : GetParam());
  const Counted counted = count_rays(scene, 161, 121);
  ASSERT_EQ(counted.edges, 0) << "a pixel too close to call: choose another size";
  for (const Scalar scalar : {Scalar::wide, Scalar::narrow, Scalar::exact})
    EXPECT_EQ(picture(scene, 161, 121, in(scalar)).rays, counted.rays);
  EXPECT_EQ(counted.rays.shadow > 0, GetParam() != '0');
}

TEST_P(EverySeed, RayCountsAreExactInRandomScenes) {
  const Scene scene = test::random_scene(static_cast<std::uint64_t>(GetParam()));
  const Counted counted = count_rays(scene, 61, 47);
  ASSERT_EQ(counted.edges, 0) << "a pixel too close to call: choose another size";
  EXPECT_EQ(picture(scene, 61, 47).rays, counted.rays);
}

}  // namespace
}  // namespace tia
