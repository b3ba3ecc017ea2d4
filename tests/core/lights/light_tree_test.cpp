// The tree of lights: chances that add up, and light that does not depend on how it is asked for.
#include "core/lights/light_tree.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/lights/light_importance.h"
#include "core/math/deterministic.h"
#include "core/math/onb.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;
using test::rounds;

// Points, spots and flat lights of very different powers.
std::vector<LightBounds> random_lights(Random& random) {
  std::vector<LightBounds> lights;
  for (int i = random.whole(5, 50); i > 0; --i) {
    LightBounds light;
    const Vec3d p = random.point(5);
    light.box = {p, p};
    light.power = random.chance(0.1) ? 0 : std::pow(10.0, random.in(-3, 3));
    if (random.chance(0.5)) {
      light.box.max = p + Vec3d{random.unit(), random.unit(), random.unit()};
      light.axis = random.direction();
      light.cos_o = random.chance(0.5) ? 1 : random.in(-1, 1);
      light.cos_e = random.chance(0.5) ? 0 : random.in(0, 1);
      light.two_sided = random.chance(0.5);
    }
    lights.push_back(light);
  }
  return lights;
}

TEST(LightTree, ChancesAddUpToOne) {
  Random random(940);
  int lit = 0;
  for (int i = 0; i < rounds(50, 5); ++i) {
    const auto lights = random_lights(random);
    const LightTree tree(lights);
    for (int k = 0; k < 40; ++k) {
      const Vec3d p = random.point(8), n = random.direction();
      double sum = 0;
      for (std::size_t light = 0; light < lights.size(); ++light) {
        const double chance = tree.chance(static_cast<int>(light), p, n);
        sum += chance;
        if (lights[light].power == 0) {
          EXPECT_EQ(chance, 0);
        }
      }
      // Less by what the tree finds out to give nothing only below.
      EXPECT_LT(sum, 1 + 1e-12);
      const auto chosen = tree.choose(p, n, random.unit());
      if (chosen.light < 0) continue;
      ++lit;
      EXPECT_GT(chosen.chance, 0);
      EXPECT_NEAR(tree.chance(chosen.light, p, n), chosen.chance, 1e-12 * chosen.chance);
    }
  }
  EXPECT_GT(lit, rounds(1500, 100));
}

// A register of them at once, at points within their boxes and far from them.
TEST(LightTree, SeveralAreWeighedAsEachAlone) {
  constexpr std::size_t size = DoubleRegister::size;
  Random random(944);
  for (int i = 0; i < rounds(1000, 50); ++i) {
    std::array<LightBounds, size> lights;
    std::array<std::array<double, size>, 12> words{};
    for (std::size_t k = 0; k < size; ++k) {
      lights[k] = random_lights(random).back();
      for (std::size_t word = 0; word < 12; ++word) words[word][k] = words_of(lights[k])[word];
    }
    const Vec3d p = random.chance(0.2) ? lights[1].box.center() : random.point(8);
    const Vec3d n = random.chance(0.2) ? Vec3d{} : random.direction();
    const auto load = [&](std::size_t k) {
      return DoubleRegister::load_unaligned(words[k].data());
    };
    std::array<double, size> all;
    importance_of(Shine<DoubleRegister>::of(load), p, n).store_unaligned(all.data());
    for (std::size_t k = 0; k < size; ++k) ASSERT_EQ(all[k], lights[k].importance(p, n));
  }
}

// A light that is alone, and one whose sister gives nothing.
TEST(LightTree, OfOneChoosesItWhereItShines) {
  const LightBounds down{{{0, 1, 0}, {0, 1, 0}}, 2, {0, -1, 0}, 1, 0};
  for (const std::vector<LightBounds>& lights :
       {std::vector{down}, std::vector{down, LightBounds{down.box, 0}}}) {
    const LightTree tree(lights);
    const Vec3d up{0, 1, 0};
    EXPECT_EQ(tree.choose({0, 0, 0}, up, 0.999).light, 0);
    EXPECT_EQ(tree.choose({0, 0, 0}, up, 0).chance, 1);
    EXPECT_EQ(tree.chance(0, {0, 0, 0}, up), 1);
    EXPECT_EQ(tree.choose({0, 2, 0}, up, 0.5).light, -1);
    EXPECT_EQ(tree.chance(0, {0, 2, 0}, up), 0);
  }
}

TEST(LightTree, ChancesOfPointsAddUpToExactlyOne) {
  Random random(941);
  for (int i = 0; i < rounds(50, 5); ++i) {
    std::vector<LightBounds> lights;
    for (int k = random.whole(5, 50); k > 0; --k) {
      const Vec3d p = random.point(5);
      lights.push_back({{p, p}, random.in(0.1, 10)});
    }
    const LightTree tree(lights);
    const Vec3d p = random.point(8), n = random.direction();
    double sum = 0;
    for (std::size_t k = 0; k < lights.size(); ++k) sum += tree.chance(static_cast<int>(k), p, n);
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

// One that gives a point something has a chance there.
TEST(LightTree, WhateverShinesCanBeChosen) {
  Random random(942);
  for (int i = 0; i < rounds(50, 5); ++i) {
    const auto lights = random_lights(random);
    const LightTree tree(lights);
    for (int k = 0; k < 40; ++k) {
      const Vec3d p = random.point(8), n = random.direction();
      for (std::size_t at = 0; at < lights.size(); ++at) {
        const LightBounds& light = lights[at];
        const Vec3d share{random.unit(), random.unit(), random.unit()};
        const Vec3d q = light.box.min + light.box.size() * share;
        const Vec3d way = normalize(p - q);
        double c = dot(light.axis, way);
        if (light.two_sided) c = std::fabs(c);
        const double angle = std::acos(std::clamp(c, -1.0, 1.0)) - std::acos(light.cos_o);
        const bool shines = std::cos(std::max(0.0, angle)) > light.cos_e + 1e-9 && angle < pi / 2;
        if (light.power > 0 && shines) {
          EXPECT_GT(tree.chance(static_cast<int>(at), p, n), 0);
        }
      }
    }
  }
}

// The sum over all lights is the mean of one light's over its chance.
TEST(LightTree, OneOfThemStandsForAll) {
  Random random(943);
  for (int i = 0; i < rounds(10, 2); ++i) {
    std::vector<LightBounds> lights;
    for (int k = random.whole(5, 50); k > 0; --k) {
      const Vec3d p = random.point(5);
      lights.push_back({{p, p}, std::pow(10.0, random.in(-2, 2))});
    }
    const LightTree tree(lights);
    const Vec3d p = random.point(8), n = random.direction();
    const auto given = [&](std::size_t k) {
      const Vec3d to = lights[k].box.min - p;
      return lights[k].power * std::fabs(dot(normalize(to), n)) / dot(to, to);
    };
    double all = 0, sum = 0, squares = 0;
    for (std::size_t k = 0; k < lights.size(); ++k) all += given(k);
    constexpr int count = 4000;
    for (int k = 0; k < count; ++k) {
      const auto chosen = tree.choose(p, n, random.unit());
      const double one = given(static_cast<std::size_t>(chosen.light)) / chosen.chance;
      sum += one, squares += one * one;
    }
    const double mean = sum / count;
    EXPECT_NEAR(mean, all, 4 * std::sqrt((squares / count - mean * mean) / count) + 1e-9 * all);
  }
}

}  // namespace
}  // namespace tia
