// The open time of a frame: its strata, and the scene whose moments they are.
#include "core/scene/open_time.h"

#include <gtest/gtest.h>

#include "core/scene/at_time.h"
#include "tests/core/support.h"

namespace tia {
namespace {

Animation with_shutter(double shutter, double fps, double duration) {
  Animation animation;
  animation.shutter = shutter, animation.fps = fps, animation.duration = duration;
  return animation;
}

TEST(OpenTime, IsPartedIntoStrataAboutTheFramesTime) {
  EXPECT_EQ(stratum_times(with_shutter(0.5, 4, 9), 2, 4),
            (std::vector<double>{1.953125, 1.984375, 2.015625, 2.046875}));
  EXPECT_EQ(stratum_times(with_shutter(1, 2, 9), 3, 1), std::vector<double>{3});
}

TEST(OpenTime, EndsWithTheAnimation) {
  EXPECT_EQ(stratum_times(with_shutter(1, 1, 2), 0, 4), (std::vector<double>{0, 0, 0.125, 0.375}));
  EXPECT_EQ(stratum_times(with_shutter(1, 1, 2), 2, 4), (std::vector<double>{1.625, 1.875, 2, 2}));
}

// A wheel of one turn in four seconds: its first frame is open from before the beginning, where it
// is as it was before the end, whatever else holds there.
TEST(OpenTime, GoesOnBeyondTheJoinOfALoop) {
  const Scene wheel = read_scene(R"x({"animation":{"duration":4,"fps":1,"shutter":1,"tracks":[
    {"target":"/options/exposure","keys":[[0,0],[4,16]],"repeat":"loop"},
    {"target":"/background","keys":[[0,0],[4,1]]},
    {"target":"/ambient_light","formula":"sqrt(t)"}]}})x");
  const auto at_frame = [&](double seconds, std::size_t stratum) {
    const auto times = stratum_times(*wheel.animation, seconds, 4);
    return at_time(wheel, times[stratum], {});
  };
  const double first[] = {14.5, 15.5, 0.5, 1.5};  // 4 a second, at -0.375, -0.125, 0.125, 0.375 s
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(at_frame(0, i).options.exposure, first[i]);
  EXPECT_EQ(at_frame(0, 0).background.r, 0);
  EXPECT_EQ(at_frame(0, 0).ambient_light.r, 0);
  EXPECT_EQ(at_frame(4, 2).options.exposure, 0.5);
  EXPECT_EQ(at_frame(4, 2).background.r, 1);
  EXPECT_TRUE(moves_within(*wheel.animation, {-0.25, -0.125}));
}

const char* const exposed_frame_scene = R"({"animation":{"duration":4,"shutter":1,"tracks":[
    {"target":"/background","keys":[[0,0],[4,1]]},
    {"target":"/options/exposure","keys":[[0,0],[4,4]]},
    {"target":"/backdrop","keys":[[0,[0,0,0]],[4,[1,1,1]]]},
    {"target":"/objects/a","visible":[[1,2]]}]},
  "backdrop":[1,0,0],
  "objects":[{"name":"a","type":"sphere","center":[0,0,-9],"radius":2}]})";

TEST(OpenTime, WhatAFrameHasButOnceIsOfItsOwnTime) {
  const Scene scene = read_scene(exposed_frame_scene), frame = at_time(scene, 2, {});
  const Scene exposed = exposed_scene(scene, frame);
  EXPECT_EQ(exposed.animation->tracks.size(), 2U);
  EXPECT_EQ(exposed.options.exposure, 2);
  const Scene before = at_time(exposed, 1.5, {}), after = at_time(exposed, 2.5, {});
  EXPECT_EQ(before.options, frame.options);
  EXPECT_EQ(after.backdrop, frame.backdrop);
  EXPECT_EQ(before.objects.size() + after.objects.size(), 1U);
  EXPECT_FALSE(before.background == after.background);
  EXPECT_EQ(at_time(exposed, 2, {}), frame);
}

TEST(OpenTime, KnowsWhetherAnythingMoves) {
  const auto moves = [](const std::string& track, std::vector<double> times) {
    const Scene scene = read_scene(R"({"animation":{"duration":4,"tracks":[)" + track + "]}}");
    return moves_within(*scene.animation, times);
  };
  const std::string keys = R"({"target":"/background","keys":[[1,0],[2,1]]})";
  EXPECT_FALSE(moves(keys, {0.5, 0.75, 1}));
  EXPECT_TRUE(moves(keys, {0.5, 0.75, 1.25}));
  EXPECT_FALSE(moves(keys, {2, 3}));
  const std::string visible = R"({"target":"/lights/0","visible":[[1,2]]})";
  EXPECT_FALSE(moves(visible, {1, 1.5}));
  EXPECT_TRUE(moves(visible, {1, 2}));
  EXPECT_TRUE(moves(R"({"target":"/fog/density","formula":"1/t"})", {0, 0})) << "told by at_time";
  EXPECT_FALSE(moves("", {0, 1}));
}

}  // namespace
}  // namespace tia
