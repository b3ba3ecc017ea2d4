// Shooting and bouncing rays, and the hybrid that corrects them: against images, Fermat and tubes.
#include "core/radio/launch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/math/onb.h"
#include "core/parallel/pool.h"
#include "tests/core/radio/rooms.h"

namespace tia {
namespace {

using test::link;
using test::paths_of;
using test::point_in;
using test::radio_scene;
using test::Random;

using Sequence = std::vector<std::pair<int, int>>;
Sequence sequence_of(const RadioPath& path) {
  Sequence all;
  for (const RadioInteraction& at : path.interactions) all.emplace_back(at.body, at.element);
  return all;
}
// Beside an edge at right angles rays meet both walls in either order, to the same image.
Sequence unordered(Sequence sequence) {
  std::sort(sequence.begin(), sequence.end());
  return sequence;
}

TEST(Launch, DirectionsAreUnitAndEven) {
  constexpr std::int64_t n = 5000;
  Vec3d sum{};
  double nearest = 4;
  for (std::int64_t i = 0; i < n; ++i) {
    const Vec3d way = launch_direction(i, n);
    EXPECT_NEAR(length(way), 1, 1e-15);
    sum = sum + way;
    nearest = std::min(nearest, length(way - launch_direction((i + 89) % n, n)));
  }
  EXPECT_LT(length(sum) / n, 1e-3);
  EXPECT_GT(nearest, 0.5 * launch_angle(n));
  EXPECT_DOUBLE_EQ(launch_angle(1000), std::sqrt(4 * pi / 1000));
}

// 60 000 rays: alpha = 0.83 degrees. A spot that is farther than 1/sqrt(3) from all directions of
// the Fibonacci sphere, of which it has a few in a hundred, no ray tells of.
TEST(Launch, RawPathsHaveEachSequenceOnceAndLengthsWithinTheBall) {
  Random random(1);
  constexpr std::int64_t rays = 60'000;
  std::size_t all = 0, missed = 0;
  for (int i = 0; i < test::rounds(3); ++i) {
    const Vec3d size = point_in(random, {3, 3, 3}, {8, 8, 8});
    const Scene room = radio_scene(test::room_text({}, size));
    RadioQuestion question = link(point_in(random, size * 0.15, size * 0.85),
                                  point_in(random, size * 0.15, size * 0.85), RadioMethod::image);
    question.max_reflections = 2;
    question.rays = rays;
    std::map<Sequence, double> exact;
    for (const RadioPath& path : paths_of(room, question)) exact[sequence_of(path)] = path.length;
    question.method = RadioMethod::sbr;
    std::set<Sequence> seen;
    for (const RadioPath& path : paths_of(room, question)) {
      EXPECT_TRUE(seen.insert(sequence_of(path)).second);
      const auto found = exact.find(sequence_of(path));
      if (found == exact.end()) continue;  // beside an edge: what the hybrid throws away
      EXPECT_LE(std::fabs(path.length - found->second),
                path.length * launch_angle(rays) / std::sqrt(3.0));
    }
    std::set<Sequence> images;
    for (const Sequence& each : seen) images.insert(unordered(each));
    for (const auto& [sequence, length] : exact) {
      ++all;
      missed += images.contains(unordered(sequence)) ? 0 : 1;
    }
  }
  EXPECT_LE(missed * 20, all);
}

TEST(Launch, HybridIsTheImageMethod) {
  Random random(2);
  for (int i = 0; i < test::rounds(3); ++i) {
    const Vec3d size = point_in(random, {4, 3, 4}, {8, 5, 8});
    // A room with a closed box and a sheet in it.
    const Scene room = radio_scene(
        test::room_text({}, size) + "," + test::box_text(size * 0.4, size * 0.55) + "," +
            test::triangle_text({0, 0, size.z * 0.3}, {size.x * 0.7, 0, size.z * 0.3},
                                {0, size.y, size.z * 0.32}),
        R"({"type":"itu","name":"wood","thickness":0.04,"through":true})");
    RadioQuestion question = link(size * 0.13, size * 0.81, RadioMethod::image, 2.4e9);
    question.max_reflections = 2;
    question.max_transmissions = i % 3;
    question.rays = 15'000;
    const auto images = paths_of(room, question);
    question.method = RadioMethod::hybrid;
    const auto hybrid = paths_of(room, question);
    ASSERT_EQ(images.size(), hybrid.size());
    for (std::size_t n = 0; n < images.size(); ++n) {
      EXPECT_NEAR(images[n].length, hybrid[n].length, 1e-9);
      EXPECT_NEAR(std::sqrt(norm_of(images[n].gain[0][0] - hybrid[n].gain[0][0])), 0, 1e-9);
    }
  }
}

// The shortest way over a ball, by halving angles in the plane of the three points; its spreading
// by Kouyoumjian and Pathak 1974, (12) and (13), for a sphere of radius a:
// 1/rho = (1/s1 + 1/s2)/2 + 1/f for both planes, by closed form 1/rho1 = 1/s + 2/(a cos), and
// 1/rho2 = 1/s + 2 cos/a.
TEST(Launch, HybridOnABallIsFermatsPathAndItsTube) {
  Random random(3);
  for (int i = 0; i < test::rounds(10); ++i) {
    const double a = random.in(0.4, 2);
    const Scene scene = radio_scene(
        R"({"type":"sphere","material":"m","center":[0,0,0],"radius":)" + number_text(a) + "}");
    const double turn = random.in(0.3, 1.2), s = a + random.in(1, 4), r = a + random.in(1, 4);
    const Vec3d from{s, 0, 0},
        to{r * std::cos(turn), r * std::sin(turn) * 0.8, r * std::sin(turn) * 0.6};
    RadioQuestion question = link(from, to, RadioMethod::hybrid);
    question.max_reflections = 1;
    question.rays = 20'000;
    const auto paths = paths_of(scene, question);
    ASSERT_EQ(paths.size(), 2U);
    const RadioPath& path = paths[1];
    const Vec3d x{1, 0, 0}, y{0, 0.8, 0.6};
    const auto way = [&](double angle) {
      const Vec3d p = (x * std::cos(angle) + y * std::sin(angle)) * a;
      return length(p - from) + length(to - p);
    };
    double low = 0, high = turn;
    for (int n = 0; n < 200; ++n) {
      const double one = low + (high - low) / 3, two = high - (high - low) / 3;
      if (way(one) < way(two)) high = two;
      else low = one;
    }
    EXPECT_NEAR(path.length, way(low), 1e-9);
    const double cosine = path.interactions.at(0).cosine;
    const double s1 = length(path.interactions[0].point - from), s2 = path.length - s1;
    const double rho1 = 1 / (1 / s1 + 2 / (a * cosine)), rho2 = 1 / (1 / s1 + 2 * cosine / a);
    const double spread = std::sqrt(rho1 * rho2 / ((rho1 + s2) * (rho2 + s2))) / s1;
    EXPECT_NEAR(path.tube * spread, 1, 1e-6);
    EXPECT_EQ(path.caustics, 0);
  }
}

// Inside a ball of radius a, straight across from the middle's other side: the tube passes a
// focus. 1/rho = 1/s1 - 2/a for both planes: two lines of caustics, together a turn of pi.
TEST(Launch, TubesTurnThePhaseAtCaustics) {
  const Scene dome = radio_scene(
      R"({"type":"quadric","material":"m","coefficients":[1,1,1,0,0,0,0,0,0,-9],
          "bounds":{"min":[-4,1,-4],"max":[4,4,4]}})");
  RadioQuestion question = link({0.1, 0.2, 0}, {-0.2, -1.5, 0.1}, RadioMethod::hybrid);
  question.max_reflections = 1;
  question.rays = 20'000;
  const auto paths = paths_of(dome, question);
  ASSERT_GE(paths.size(), 2U);
  const RadioPath& path = paths[1];
  const double cosine = path.interactions.at(0).cosine;
  const double s1 = length(path.interactions[0].point - question.transmitters[0].position);
  const double s2 = path.length - s1;
  const double rho1 = 1 / (1 / s1 - 2 / (3 * cosine)), rho2 = 1 / (1 / s1 - 2 * cosine / 3);
  ASSERT_LT(rho1, 0);
  ASSERT_LT(-rho1, s2);
  EXPECT_EQ(path.caustics, 2);
  const double spread = std::sqrt(rho1 * rho2 / ((rho1 + s2) * (rho2 + s2))) / s1;
  EXPECT_NEAR(path.tube * spread, 1, 1e-5);
}

// A paraboloid z = (x^2 + y^2)/(4 f), f = 2, gathers what comes from its focus into parallel rays:
// by whichever point, the way to a plane across the axis is as long.
TEST(Launch, ParaboloidSendsItsFocusAlongTheAxis) {
  const Scene dish = radio_scene(
      R"({"type":"quadric","material":"m","coefficients":[0.125,0.125,0,0,0,0,0,0,-1,0],
          "bounds":{"min":[-3,-3,-1],"max":[3,3,1.2]}})");
  Random random(4);
  for (int i = 0; i < test::rounds(5); ++i) {
    const double x = random.in(0.4, 2), y = random.in(0.4, 1.5), far = random.in(5, 9);
    RadioQuestion question = link({0, 0, 2}, {x, y, far}, RadioMethod::hybrid);
    question.max_reflections = 1;
    question.rays = 4000;
    const auto paths = paths_of(dish, question);
    ASSERT_EQ(paths.size(), 2U);
    EXPECT_NEAR(paths[1].length, far + 2, 1e-9);
    EXPECT_NEAR(paths[1].interactions[0].point.x, x, 1e-8);
    // The tube no longer widens: its area over the solid angle is (f + (x^2 + y^2)/4f)^2.
    EXPECT_NEAR(paths[1].tube, 2 + (x * x + y * y) / 8, 1e-5);
  }
}

TEST(Launch, ThreadsChangeNothing) {
  const Scene room = radio_scene(test::room_text({}, {6, 4, 5}) + "," +
                                     R"({"type":"sphere","material":"m","center":[3,2,1],
                                         "radius":0.7})",
                                 R"({"type":"itu","name":"brick"})");
  RadioQuestion question = link({1, 1, 1}, {5, 3, 4}, RadioMethod::hybrid);
  question.receivers.push_back({.name = "second", .position = {4, 1, 1}});
  question.max_reflections = 2;
  question.rays = 5000;
  question.channel = ChannelQuestion{{-1e6, 0, 1e6}, {1e-8, 3e-8}, 1e8};
  for (const RadioMethod method : {RadioMethod::hybrid, RadioMethod::sbr}) {
    question.method = method;
    const auto text = [&](const Workers& workers) {
      return to_json(
          radio_paths_json(question, radio_paths(room, question, RadioLimits{}, workers)));
    };
    const std::string alone = text({});
    for (const int threads : {2, 7}) {
      Pool pool(threads);
      EXPECT_EQ(text(pool.workers(threads)), alone);
    }
  }
}

}  // namespace
}  // namespace tia
