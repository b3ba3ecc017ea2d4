// The image method: closed forms of rooms, walls and grounds, and what pruning must not lose.
#include "core/radio/images.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>

#include "core/math/onb.h"
#include "core/radio/fresnel.h"
#include "tests/core/radio/rooms.h"

namespace tia {
namespace {

using test::link;
using test::paths_of;
using test::plane_text;
using test::point_in;
using test::radio_scene;
using test::Random;
using Std = std::complex<double>;
constexpr double c = 299792458;
constexpr RadioMethod image = RadioMethod::image;

double decibels(double power) { return 10 * std::log10(power); }

// H. T. Friis, "A note on a simple transmission formula" (1946).
TEST(RadioPaths, FreeSpaceIsFriis) {
  Random random(1);
  for (int i = 0; i < 30; ++i) {
    const Vec3d from = point_in(random, {-1, -1, -1}, {1, 1, 1});
    const Vec3d to = point_in(random, {20, -90, 5}, {90, 90, 90});
    const double hz = random.in(1e8, 6e10), metres = length(to - from);
    const auto answer = radio_paths(Scene{}, link(from, to, image, hz));
    ASSERT_EQ(answer.pairs.size(), 1U);
    ASSERT_EQ(answer.pairs[0].paths.size(), 1U);
    const double loss = c / hz / (4 * pi * metres);
    EXPECT_NEAR(*answer.pairs[0].total.coherent_db, decibels(loss * loss), 1e-9);
    EXPECT_NEAR(*answer.pairs[0].total.incoherent_db, decibels(loss * loss), 1e-9);
    EXPECT_NEAR(*answer.pairs[0].total.mean_delay_s, metres / c, 1e-15);
    EXPECT_FALSE(answer.pairs[0].total.k_factor_db);
    const Complex gain = answer.pairs[0].paths[0].gain[0][0];
    const Std phase = std::polar(loss, -2 * pi * hz / c * metres);
    EXPECT_NEAR(std::abs(Std(gain.re, gain.im) - phase) / loss, 0, 1e-9);
  }
}

// The point by similar triangles; the way over it is the shortest, by second differences.
TEST(RadioPaths, OneWallMirrorsWhereTheWayIsStationary) {
  Random random(2);
  for (int i = 0; i < 30; ++i) {
    const Vec3d from = point_in(random, {-5, 1, -5}, {5, 9, 5}),
                to = point_in(random, {-5, 1, -5}, {5, 9, 5});
    const auto paths =
        paths_of(radio_scene(plane_text({3, 0, 8}, {0, 2, 0})), link(from, to, image));
    ASSERT_EQ(paths.size(), 2U);
    const RadioInteraction& at = paths[1].interactions.at(0);
    const double share = from.y / (from.y + to.y);
    const Vec3d foot{from.x + (to.x - from.x) * share, 0, from.z + (to.z - from.z) * share};
    EXPECT_NEAR(length(at.point - foot), 0, 1e-12);
    const auto way = [&](double x, double z) {
      const Vec3d p = at.point + Vec3d{x, 0, z};
      return length(p - from) + length(to - p);
    };
    EXPECT_NEAR(paths[1].length, way(0, 0), 1e-12);
    EXPECT_NEAR(at.cosine, (from.y + to.y) / paths[1].length, 1e-12);
    constexpr double h = 1e-4;
    for (const auto& [x, z] : {std::pair{h, 0.0}, {0.0, h}}) {
      EXPECT_NEAR((way(x, z) - way(-x, -z)) / (2 * h), 0, 1e-8);
      EXPECT_GT(way(x, z) + way(-x, -z) - 2 * way(0, 0), 0);
    }
  }
}

TEST(RadioPaths, CornerOfTwoConductorsHasFourPathsAndAWallNoField) {
  const Scene corner = radio_scene(plane_text({}, {1, 0, 0}) + "," + plane_text({}, {0, 0, 1}));
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const Vec3d from = point_in(random, {1, -3, 1}, {6, 3, 6});
    const Vec3d to = point_in(random, {1, -3, 1}, {6, 3, 6});
    ASSERT_EQ(paths_of(corner, link(from, to, image)).size(), 4U);
    // y is along both walls, so what V receives there is tangential.
    const auto total = [&](double off) {
      const auto answer = radio_paths(corner, link(from, {off, from.y, to.z}, image));
      return std::sqrt(std::pow(10, *answer.pairs[0].total.coherent_db / 10));
    };
    const double near = total(1e-6), twice = total(2e-6);
    EXPECT_NEAR(twice / near, 2, 1e-5);  // so it is 0 at 0
  }
}

// Allen, Berkley 1979: per axis images at 2 m L + x, |2m| times mirrored, and 2 m L - x, |2m - 1|.
TEST(RadioPaths, ShoeboxHasTheLatticeOfAllenAndBerkley) {
  Random random(4);
  for (int i = 0; i < 4; ++i) {
    const Vec3d size = point_in(random, {3, 3, 3}, {9, 9, 9});
    const Vec3d from = point_in(random, size * 0.1, size * 0.9);
    const Vec3d to = point_in(random, size * 0.1, size * 0.9);
    std::array<std::vector<double>, 4> expected;
    std::array<std::vector<std::pair<double, int>>, 3> axis;
    const std::array<double, 3> l{size.x, size.y, size.z}, s{from.x, from.y, from.z},
        r{to.x, to.y, to.z};
    for (std::size_t k = 0; k < 3; ++k)
      for (int m = -2; m <= 2; ++m) {
        axis[k].push_back({2 * m * l[k] + s[k] - r[k], std::abs(2 * m)});
        axis[k].push_back({2 * m * l[k] - s[k] - r[k], std::abs(2 * m - 1)});
      }
    for (const auto& [x, a] : axis[0])
      for (const auto& [y, b] : axis[1])
        for (const auto& [z, d] : axis[2])
          if (a + b + d <= 3)
            expected[static_cast<std::size_t>(a + b + d)].push_back(
                std::sqrt(x * x + y * y + z * z));
    std::array<std::vector<double>, 4> got;
    for (const RadioPath& path :
         paths_of(radio_scene(test::room_text({}, size)), link(from, to, image)))
      got.at(path.interactions.size()).push_back(path.length);
    for (std::size_t order = 0; order < 4; ++order) {
      std::sort(expected[order].begin(), expected[order].end());
      ASSERT_EQ(got[order].size(), (std::array<std::size_t, 4>{1, 6, 18, 38}[order]));
      for (std::size_t n = 0; n < got[order].size(); ++n)
        EXPECT_NEAR(got[order][n], expected[order].at(n), 1e-11);
    }
  }
}

// Rappaport, "Wireless Communications", 2nd ed. (2002), 4.6: the sum of two rays, written out.
TEST(RadioPaths, TwoRayGroundIsItsFormula) {
  Random random(5);
  int compared = 0;
  for (int i = 0; i < 60; ++i) {
    const bool lossy = random.chance(0.5), horizontal = random.chance(0.5);
    const double h = random.in(2, 40), g = random.in(1, 10), hz = random.in(3e8, 3e9);
    const double d = 20 * std::pow(1000, random.unit());
    const std::string ground = R"({"type":"itu","name":"medium_dry_ground"})";
    const Scene scene = lossy ? radio_scene(plane_text({}, {0, 1, 0}), ground)
                              : radio_scene(plane_text({}, {0, 1, 0}));
    RadioQuestion question = link({0, h, 0}, {d * 0.6, g, d * 0.8}, image, hz);
    question.transmitters[0].polarization = question.receivers[0].polarization =
        horizontal ? Polarization::horizontal : Polarization::vertical;
    const double direct = std::hypot(d, h - g), bounced = std::hypot(d, h + g);
    const double cosine = (h + g) / bounced, ghz = hz / 1e9;
    const Std eta(15 * std::pow(ghz, -0.1),
                  -0.035 * std::pow(ghz, 1.63) / (2 * pi * hz * 8.8541878128e-12));
    const Std q = std::sqrt(eta - (1 - cosine * cosine));
    const Std r = !lossy       ? Std(horizontal ? -1 : 1)
                  : horizontal ? (cosine - q) / (cosine + q)
                               : (eta * cosine - q) / (eta * cosine + q);
    const double k = 2 * pi * hz / c;
    const Std sum = std::polar(1 / direct, -k * direct) + r * std::polar(1 / bounced, -k * bounced);
    if (std::abs(sum) * d < 0.05) continue;  // in a null rounding is all there is
    ++compared;
    const double loss = c / hz / (4 * pi) * std::abs(sum);
    EXPECT_NEAR(*radio_paths(scene, question).pairs[0].total.coherent_db, decibels(loss * loss),
                1e-6);
  }
  EXPECT_GT(compared, 35);
}

// Beyond the breakpoint 4 h g/lambda the gain is (h g/d^2)^2, 40 dB a decade.
TEST(RadioPaths, BeyondTheBreakpointPowerFallsByTheFourthPower) {
  const double h = 10, g = 2, hz = 1e9, edge = 4 * h * g / (c / hz);
  const Scene scene = radio_scene(plane_text({}, {0, 1, 0}));
  const auto gain = [&](double d) {
    RadioQuestion question = link({0, h, 0}, {d, g, 0}, image, hz);
    question.transmitters[0].polarization = question.receivers[0].polarization =
        Polarization::horizontal;
    return *radio_paths(scene, question).pairs[0].total.coherent_db;
  };
  for (const double d : {20 * edge, 60 * edge})
    EXPECT_NEAR(gain(d), decibels(std::pow(h * g / (d * d), 2)), 0.01);
  EXPECT_NEAR(gain(20 * edge) - gain(60 * edge), 40 * std::log10(3), 0.01);
  // There both rays add up for the last time, and cancel where it is half as far.
  EXPECT_GT(gain(edge), gain(1.5 * edge));
  EXPECT_LT(gain(edge / 2), gain(edge) - 20);
}

// Scenes by chance: boxes and open triangles.
Scene random_scene(Random& random, int faces, const std::string& material) {
  std::string objects;
  const auto more = [&](const std::string& text) {
    objects += (objects.empty() ? "" : ",") + text;
  };
  for (int left = faces; left > 0;) {
    const Vec3d p = point_in(random, {-8, -8, -8}, {8, 8, 8});
    if (left >= 6 && random.chance(0.4)) {
      more(test::box_text(p, p + point_in(random, {0.2, 0.2, 0.2}, {3, 3, 3})));
      left -= 6;
    } else {
      const Vec3d q = p + point_in(random, {-5, -5, -5}, {5, 5, 5});
      more(test::triangle_text(p, q, p + point_in(random, {-5, -5, -5}, {5, 5, 5})));
      --left;
    }
  }
  return radio_scene(objects, material);
}

// Where that is, away from all bodies.
Vec3d free_place(Random& random, const RadioWorld& world) {
  for (;;) {
    const Vec3d p = point_in(random, {-9, -9, -9}, {9, 9, 9});
    if (world.body_around(p) < 0) return p;
  }
}

TEST(RadioPaths, PruningLosesNothingAgainstTheFullTree) {
  Random random(6);
  std::size_t found = 0;
  for (int i = 0; i < 50; ++i) {
    const RadioWorld world(random_scene(random, 30, R"({"type":"itu","name":"glass"})"));
    const int walls = i % 3;
    PathSearch search;
    search.from = free_place(random, world);
    search.max_reflections = i % 5 == 0 ? 3 : 2;
    search.max_transmissions = walls;
    search.most_images = 1 << 30;
    for (int k = 0; k < 8; ++k) search.to.push_back(free_place(random, world));
    const PathsTo pruned = paths_by_images(world, search, {});
    search.pruned = false;
    const PathsTo full = paths_by_images(world, search, {});
    EXPECT_LT(pruned.counts.images, full.counts.images);
    for (std::size_t k = 0; k < search.to.size(); ++k) {
      ASSERT_EQ(pruned.by_receiver[k].size(), full.by_receiver[k].size());
      found += pruned.by_receiver[k].size();
      for (std::size_t n = 0; n < full.by_receiver[k].size(); ++n)
        EXPECT_EQ(pruned.by_receiver[k][n].length, full.by_receiver[k][n].length);
    }
  }
  EXPECT_GT(found, 300U);
}

TEST(RadioPaths, AreTheSameBothWays) {
  Random random(7);
  std::size_t found = 0;
  for (int i = 0; i < 20; ++i) {
    const Scene scene = random_scene(
        random, 20, R"({"type":"itu","name":"plasterboard","thickness":0.03,"through":true})");
    const RadioWorld world(scene);
    RadioQuestion question =
        link(free_place(random, world), free_place(random, world), image, 2.4e8);
    question.max_reflections = 2;
    question.max_transmissions = 2;
    question.transmitters[0].polarization = Polarization::cross;
    question.receivers[0].polarization = Polarization::slant;
    question.receivers[0].orientation_degrees = {30, 40, 50};
    question.transmitters[0].pattern = AntennaPattern::patch;
    RadioQuestion back = question;
    std::swap(back.transmitters, back.receivers);
    const auto there = paths_of(scene, question), again = paths_of(scene, back);
    ASSERT_EQ(there.size(), again.size());
    found += there.size();
    for (std::size_t n = 0; n < there.size(); ++n)
      for (std::size_t r = 0; r < 2; ++r)
        for (std::size_t t = 0; t < 2; ++t) {
          const Complex off = there[n].gain[r][t] - again[n].gain[t][r];
          EXPECT_LE(std::sqrt(norm_of(off)),
                    1e-12 * std::sqrt(power_of(there[n].gain, 2, 2)) + 1e-18);
        }
  }
  EXPECT_GT(found, 20U);
}

TEST(RadioPaths, AScreenTakesAwayThatPathAlone) {
  const std::string ground = plane_text({}, {0, 1, 0});
  const RadioQuestion question = link({0, 3, 0}, {20, 3, 0}, image);
  const auto open = paths_of(radio_scene(ground), question);
  const auto shut = paths_of(
      radio_scene(ground + "," + test::box_text({9, 2.6, -0.2}, {11, 3.4, 0.2})), question);
  ASSERT_EQ(open.size(), 2U);
  // Nothing of the box is seen by both but its sides' ends, which face neither.
  for (const RadioPath& path : shut) EXPECT_FALSE(path.interactions.empty());
  EXPECT_NE(std::find_if(shut.begin(), shut.end(),
                         [&](const RadioPath& path) { return path.length == open[1].length; }),
            shut.end());
}

TEST(RadioPaths, TurnedMovedAndScaledWorldsHaveTheSameGains) {
  Random random(8);
  for (int i = 0; i < test::rounds(10); ++i) {
    const Scene scene = random_scene(random, 24, R"({"type":"dielectric",
      "relative_permittivity":4,"conductivity":0.02,"thickness":0.05})");
    const RadioWorld world(scene);
    RadioQuestion question = link(free_place(random, world), free_place(random, world), image, 3e8);
    question.max_transmissions = 1;
    const auto before = radio_paths(scene, question).pairs[0];
    // Turned about the antennas' own axis, so that V stays V; then twice as large by its unit.
    Scene moved = scene;
    for (Object& object : moved.objects.edit()) {
      object.transform.steps.push_back(RotateDegrees{{0, 37, 0}});
      object.transform.steps.push_back(Translate{{3, -2, 5}});
    }
    const Affine map = Affine::translation({3, -2, 5}) * Affine::rotation_degrees({0, 37, 0});
    question.transmitters[0].position = map.point(question.transmitters[0].position);
    question.receivers[0].position = map.point(question.receivers[0].position);
    const auto after = radio_paths(moved, question).pairs[0];
    ASSERT_EQ(before.paths.size(), after.paths.size());
    for (std::size_t n = 0; n < before.paths.size(); ++n)
      EXPECT_NEAR(std::sqrt(norm_of(before.paths[n].gain[0][0] - after.paths[n].gain[0][0])), 0,
                  1e-9);
  }
}

// Half the unit at twice the frequency: of bodies whose eta is the same, the same relative phases.
TEST(RadioPaths, ScalingWithTheWavelengthChangesNoGain) {
  Random random(9);
  const Scene scene = radio_scene(test::room_text({}, {5, 4, 3}));
  RadioQuestion question = link({1, 1, 1}, {4, 3, 2}, image, 1e9);
  const auto before = radio_paths(scene, question).pairs[0];
  question.frequency_hz *= 2;
  question.unit_metres = 0.5;
  const auto after = radio_paths(scene, question).pairs[0];
  ASSERT_EQ(before.paths.size(), after.paths.size());
  EXPECT_NEAR(*before.total.coherent_db, *after.total.coherent_db, 1e-9);
  EXPECT_NEAR(*before.total.delay_spread_s, 2 * *after.total.delay_spread_s, 1e-20);
}

// -1/(2 pi) d phase/dt, by a central difference.
TEST(RadioPaths, DopplerIsHowThePhaseTurns) {
  const Scene room = radio_scene(test::room_text({}, {6, 5, 4}), R"({"type":"itu","name":"wood"})");
  RadioQuestion question = link({1.1, 0.93, 1.27}, {4.31, 3.17, 2.29}, image, 2e9);
  question.transmitters[0].velocity = {3, -1, 2};
  question.receivers[0].velocity = {-2, 0.5, 1};
  question.max_reflections = 2;
  const LinkWave wave{{2e9}, 1};
  const auto at = [&](double t) {
    RadioQuestion moved = question;
    moved.transmitters[0].position = moved.transmitters[0].position + Vec3d{3, -1, 2} * t;
    moved.receivers[0].position = moved.receivers[0].position + Vec3d{-2, 0.5, 1} * t;
    return paths_of(room, moved);
  };
  constexpr double h = 1e-5;
  const auto paths = at(0), later = at(h), sooner = at(-h);
  ASSERT_EQ(paths.size(), 25U);
  for (std::size_t n = 0; n < paths.size(); ++n)
    EXPECT_NEAR(doppler_of(paths[n], wave, question.transmitters[0], question.receivers[0]),
                -(later[n].length - sooner[n].length) / (2 * h) / wave.wave.length(), 1e-4);
}

// Straight through a wall, as a sheet and as a body that lets waves through: once as a slab, once
// as its two faces, the echoes left out.
TEST(RadioPaths, WallsLetThroughWhatTheirSlabDoes) {
  const double hz = 5e9, d = 0.2;
  RadioQuestion question = link({0, 1, 0}, {9, 2, 3}, image, hz);
  question.max_transmissions = 1;
  question.max_reflections = 0;
  const std::string glass = R"({"type":"itu","name":"concrete","thickness":0.2,"through":true})";
  const double cosine = 9 / std::sqrt(81 + 1 + 9.0);
  const auto sheet_path = paths_of(radio_scene(plane_text({4, 0, 0}, {1, 0, 0}), glass), question);
  const auto body_path =
      paths_of(radio_scene(test::box_text({4, -5, -5}, {4 + d, 9, 9}), glass), question);
  const auto free = paths_of(Scene{}, question);
  ASSERT_EQ(sheet_path.size(), 1U);
  ASSERT_EQ(body_path.size(), 1U);
  EXPECT_EQ(sheet_path[0].interactions.size(), 1U);
  ASSERT_EQ(body_path[0].interactions.size(), 2U);
  EXPECT_NEAR(body_path[0].interactions[0].inside, d / cosine, 1e-12);
  const Complex eta = matter_of({ItuRadio{}}, {hz}).eta;
  const Polarized r = half_space(eta, cosine);
  const double kd = 2 * pi * hz / c * d;
  const Std excess(excess_of(eta, cosine).re, excess_of(eta, cosine).im);
  const auto once = [&](const Complex& of) {
    const Std each(of.re, of.im);
    return (1.0 - each * each) * std::exp(Std(0, -1) * kd * excess);
  };
  const auto ratio = [&](const RadioPath& path) {
    const Complex is = path.gain[0][0] / free[0].gain[0][0];
    return Std(is.re, is.im);
  };
  // V is a mixture of both: s is across x and the ray, and V's own share of it.
  const Vec3d way = unit(Vec3d{9, 1, 3}), s = unit(cross(way, Vec3d{1, 0, 0}));
  const Vec3d v = ports_of(question.transmitters[0], way).field[0];
  const double share = dot(v, s) * dot(v, s);
  EXPECT_NEAR(std::abs(ratio(body_path[0]) -
                       (share * once(r.perpendicular) + (1 - share) * once(r.parallel))),
              0, 1e-10);
  const SheetFactors slab = sheet(eta, cosine, d, {hz});
  const Complex expected =
      slab.transmitted.perpendicular * share + slab.transmitted.parallel * (1 - share);
  EXPECT_NEAR(std::abs(ratio(sheet_path[0]) - Std(expected.re, expected.im)), 0, 1e-10);
}

}  // namespace
}  // namespace tia
