// What becomes of a motion: tracks that put bodies where the solver has them.
#include "core/motion/bake.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/motion/exact.h"
#include "core/motion/simulate.h"
#include "core/scene/at_time.h"
#include "tests/core/faults.h"
#include "tests/core/support.h"

namespace tia {
namespace {

constexpr std::size_t usual_events = 1'000'000;

// Where the middle of the ball at a path of objects is at a time.
Vec3d middle_at(const Scene& baked, double time, std::vector<std::size_t> path) {
  const Scene plain = at_time(baked, time, {});
  const std::vector<Object>* list = &plain.objects.get();
  Affine place;
  for (const std::size_t i : path) {
    const Object& object = (*list)[i];
    place = place * object.transform.affine();
    if (const auto* ball = std::get_if<Sphere>(&object.shape)) return place.point(ball->center);
    list = children_of(object);
  }
  return {};
}

// A ball of restitution 1/2 that falls from 5 under g = 10: it is down at 1, 2, 2.5, 2.75, ... s.
const std::string falling_ball = R"({"objects":[
    {"name":"floor","type":"plane","point":[0,0,0],"normal":[0,1,0]},
    {"name":"ball","type":"sphere","center":[0,1,0],"radius":1,"transform":[{"translate":[2,5,0]}]}],
  "physics":{"gravity":[0,-10,0],"duration":2.5,"bodies":[
      {"object":"ball","mass":2,"velocity":[3,0,0],"restitution":0.5}],
    "fixed":[{"object":"floor"}]}})";
double falling_height(double t) {
  if (t <= 1) return 5 - 5 * t * t;
  if (t <= 2) return 5 * (t - 1) - 5 * (t - 1) * (t - 1);
  return 2.5 * (t - 2) - 5 * (t - 2) * (t - 2);
}

TEST(Bake, PutsABallWhereItsParabolasAre) {
  const Scene scene = read_scene(falling_ball);
  const Simulation made = simulate(scene, usual_events);
  const Scene baked = with_motion(scene, made);
  EXPECT_FALSE(baked.physics);
  ASSERT_TRUE(baked.animation);
  EXPECT_EQ(baked.animation->duration, 2.5);
  for (int k = 0; k <= 50; ++k) {
    const double t = k * 0.05;
    const Vec3d expected{2 + 3 * t, 1 + falling_height(t), 0};
    EXPECT_NEAR(length(middle_at(baked, t, {1}) - expected), 0, 1e-12) << t;
  }
  ASSERT_GE(made.contacts.size(), 2);
  EXPECT_NEAR(made.contacts[0].time, 1, 1e-12);
  EXPECT_EQ(made.contacts[0].a, "ball");
  EXPECT_EQ(made.contacts[0].b, "floor");
  EXPECT_NEAR(made.contacts[0].impulse, 2 * (10 + 5), 1e-11);
  EXPECT_NEAR(length(made.contacts[0].normal - Vec3d{0, 1, 0}), 0, 1e-12);
}

// Steps of frames are no part of a motion: at times that they share all rates show the same scene.
TEST(Bake, DoesNotDependOnFramesASecond) {
  const auto baked_at = [](int fps) {
    const Scene scene = read_scene(R"({"animation":{"duration":2.5,"fps":)" + std::to_string(fps) +
                                   "}," + falling_ball.substr(1));
    return with_motion(scene, simulate(scene, usual_events));
  };
  const Scene at24 = baked_at(24), at60 = baked_at(60), at240 = baked_at(240);
  for (int k = 0; k <= 30; ++k) {
    const double t = k / 12.0;
    EXPECT_EQ(at_time(at24, t, {}).objects, at_time(at60, t, {}).objects);
    EXPECT_EQ(at_time(at24, t, {}).objects, at_time(at240, t, {}).objects);
  }
}

TEST(Bake, AtTheTimeZeroNothingHasMoved) {
  const Scene scene = read_scene(falling_ball);
  const Scene baked = with_motion(scene, simulate(scene, usual_events));
  EXPECT_EQ(baked.objects[1].transform.affine(), scene.objects[1].transform.affine());
  const Scene plain = at_time(baked, 0, {});
  EXPECT_EQ(plain.objects[1].transform.affine(), scene.objects[1].transform.affine());
}

TEST(Bake, KeepsTheSolversPathsAtAndBetweenKnots) {
  // Six balls in a box, of different masses.
  std::string balls, bodies;
  for (int i = 0; i < 6; ++i) {
    const std::string name = "b" + std::to_string(i), x = std::to_string(3 * i - 7);
    balls += R"(,{"name":")" + name + R"(","type":"sphere","center":[)" + x + "," + x +
             R"(,0.25],"radius":1})";
    bodies += (i > 0 ? "," : "") + (R"({"object":")" + name) + R"(","density":)" +
              std::to_string(1 + i) + R"(,"velocity":[)" + std::to_string(2 - i) + "," +
              std::to_string(i) + ",0.5]}";
  }
  const Scene scene = read_scene(R"({"objects":[
      {"name":"room","type":"box","min":[-12,-12,-12],"max":[12,12,12]})" +
                                 balls + R"(],"physics":{"duration":4,"bodies":[)" + bodies +
                                 R"(],"fixed":[{"object":"room"}]}})");
  ExactWorld world{
      {0, -9.81, 0}, 4, {}, {FixedBox{{-12, -12, -12}, {{{24, 0, 0}, {0, 24, 0}, {0, 0, 24}}}}}};
  for (int i = 0; i < 6; ++i) {
    const double x = 3 * i - 7, volume = 4 * pi / 3;
    world.balls.push_back({{x, x, 0.25}, {2.0 - i, 1.0 * i, 0.5}, 1, volume * (1 + i)});
  }
  const Motion motion = solve_exact(world, usual_events);
  const Scene baked = with_motion(scene, simulate(scene, usual_events));
  ASSERT_GT(motion.events, 6);
  for (std::size_t i = 0; i < 6; ++i) {
    const std::vector<Knot>& knots = motion.paths[i];
    for (std::size_t k = 0; k < knots.size(); ++k) {
      const double next = k + 1 < knots.size() ? knots[k + 1].time : 4;
      for (const double t : {knots[k].time, 0.7 * knots[k].time + 0.3 * next})
        EXPECT_NEAR(length(middle_at(baked, t, {i + 1}) - center_at(knots[k], t)), 0, 2e-12) << t;
    }
  }
}

TEST(Bake, InTurnedGroupsTheStepIsInTheirSpace) {
  const Scene scene = read_scene(R"({"objects":[
      {"type":"group","transform":[{"rotate_degrees":[0,0,90]},{"translate":[1,2,3]}],"children":[
          {"name":"ball","type":"sphere","center":[0,0,0],"radius":1}]}],
    "physics":{"gravity":[0,-2,0],"duration":2,"bodies":[
        {"object":"ball","mass":1,"velocity":[1,0,0]}]}})");
  const Scene baked = with_motion(scene, simulate(scene, usual_events));
  EXPECT_EQ(baked.animation->tracks[0].target, "/objects/0/children/0/transform/0/translate");
  for (const double t : {0.0, 0.5, 1.3, 2.0})
    EXPECT_NEAR(length(middle_at(baked, t, {0, 0}) - Vec3d{1 + t, 2 - t * t, 3}), 0, 1e-12);
}

TEST(Bake, TracksOfItsOwnStayAndTheLongerDurationHolds) {
  const Scene scene = read_scene(R"({"objects":[
      {"name":"ball","type":"sphere","center":[0,0,0],"radius":1}],
    "animation":{"duration":1,"fps":10,"tracks":[
        {"target":"/objects/ball/material/color","keys":[[0,[1,0,0]],[1,[0,1,0]]]}]},
    "physics":{"duration":2,"bodies":[{"object":"ball","mass":1}]}})");
  const Scene baked = with_motion(scene, simulate(scene, usual_events));
  EXPECT_EQ(baked.animation->duration, 2);
  EXPECT_EQ(baked.animation->fps, 10);
  ASSERT_EQ(baked.animation->tracks.size(), 2);
  EXPECT_EQ(baked.animation->tracks[0], scene.animation->tracks[0]);
  EXPECT_EQ(canonical_text(read_scene(canonical_text(baked))), canonical_text(baked));
}

// It waits where it is written, unseen, and flies from when it comes.
TEST(Bake, ANewBallFliesFromWhenItIsThere) {
  const Scene scene = read_scene(R"({"objects":[
      {"name":"new","type":"sphere","center":[0,9,0],"radius":1}],
    "animation":{"duration":1,"tracks":[{"target":"/objects/new","visible":[[0.5,9]]}]},
    "physics":{"gravity":[0,-10,0],"duration":2,"bodies":[
        {"object":"new","mass":1,"velocity":[4,0,0]}]}})");
  const Scene baked = with_motion(scene, simulate(scene, usual_events));
  EXPECT_TRUE(at_time(baked, 0.25, {}).objects.empty());
  EXPECT_EQ(middle_at(baked, 0.5, {0}), (Vec3d{0, 9, 0}));
  EXPECT_NEAR(length(middle_at(baked, 1.5, {0}) - Vec3d{4, 4, 0}), 0, 1e-12);
}

TEST(Simulate, OverlapsNameBothAndTheTime) {
  const auto refused = [](const std::string& visible, const std::string& when) {
    const Scene scene = read_scene(R"({"objects":[
        {"name":"a","type":"sphere","center":[0,0,0],"radius":1},
        {"name":"b","type":"sphere","center":[1,0,0],"radius":1}],
      "animation":{"duration":1,"tracks":[)" +
                                   visible + R"(]},
      "physics":{"gravity":[0,0,0],"bodies":[{"object":"a","mass":1},{"object":"b","mass":1}]}})");
    test::expect_faults(
        test::faults_of([&] { simulate(scene, usual_events, Place{}.at("scene")); }),
        {{FaultKind::conflict, "/scene/physics/bodies/0/object", "\"a\"", when + " s it is in b"}});
  };
  refused("", "at 0");
  refused(R"({"target":"/objects/b","visible":[[0.5,9]]})", "at 0.5");
}

TEST(Simulate, MoreEventsThanAllowedAreRefusedWithTheTime) {
  const Scene scene = read_scene(R"({"objects":[
      {"name":"a","type":"sphere","center":[0,0,0],"radius":1},
      {"name":"room","type":"box","min":[-2,-2,-2],"max":[2,2,2]}],
    "physics":{"gravity":[0,0,0],"duration":100,"fixed":[{"object":"room"}],
      "bodies":[{"object":"a","mass":1,"velocity":[100,0,0]}]}})");
  test::expect_faults(test::faults_of([&] { simulate(scene, 100); }),
                      {{FaultKind::limit, "/physics/duration", "100", "at most 100 events"}});
}

TEST(Simulate, EndsWhenItIsStopped) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(simulate(read_scene(falling_ball), usual_events, {}, source.get_token()), Stopped);
}

}  // namespace
}  // namespace tia
