// A track's value at a time, against closed forms.
#include "core/scene/animation_track.h"

#include <gtest/gtest.h>

#include "core/math/deterministic.h"
#include "tests/core/support.h"

namespace tia {
namespace {

Track track_in(const std::string& members) {
  return read_described<Track>(parse_json(R"({"target":"/options/exposure",)" + members + "}"));
}
Value valued(const Track& track, double seconds, TrackTarget target = TrackTarget::numbers) {
  const auto value = value_at(track, target, seconds);
  return value ? *value : Value();
}
double number_at(const Track& track, double seconds) {
  return *valued(track, seconds).as<double>();
}
std::vector<double> list_at(const Track& track, double seconds,
                            TrackTarget target = TrackTarget::numbers) {
  std::vector<double> numbers;
  const Value value = valued(track, seconds, target);
  for (const Value& each : *value.as<Value::Array>()) numbers.push_back(*each.as<double>());
  return numbers;
}
std::string key_text(double time, const Value& value) { return to_json(Value::Array{time, value}); }

// Keys of random numbers or points at times that ascend.
struct RandomKeys {
  std::vector<double> times;
  std::vector<Value> values;
  std::string text = R"("keys":[)";

  RandomKeys(test::Random& random, int count, std::size_t size) {
    double time = random.in(-2, 2);
    for (int i = 0; i < count; ++i) {
      times.push_back(time);
      Value::Array list;
      for (std::size_t k = 0; k < size; ++k) list.emplace_back(random.in(-5, 5));
      values.push_back(size == 1 ? list.front() : Value(list));
      text += (i > 0 ? "," : "") + key_text(time, values.back());
      time += random.in(0.01, 2);
    }
    text += "]";
  }
};

// ---- keys -----------------------------------------------------------------------------------

TEST(AnimationTrack, IsItsKeysAtTheirTimes) {
  test::Random random(1);
  for (int i = 0; i < 60; ++i) {
    const std::size_t size = i % 2 == 0 ? 1 : 3;
    const RandomKeys keys(random, random.whole(1, 6), size);
    for (const char* way : {"linear", "step", "smooth"})
      for (const char* repeat : {"once", "pingpong"}) {
        const Track track =
            track_in(keys.text + R"(,"interpolation":")" + way + R"(","repeat":")" + repeat + "\"");
        for (std::size_t k = 0; k < keys.times.size(); ++k)
          EXPECT_EQ(valued(track, keys.times[k]), keys.values[k]) << way << repeat << k;
      }
  }
}

TEST(AnimationTrack, HoldsBeforeItsFirstKeyAndAfterItsLast) {
  const Track track = track_in(R"("keys":[[1,5],[2,7]])");
  EXPECT_EQ(number_at(track, 0), 5);
  EXPECT_EQ(number_at(track, 1.5), 6);
  EXPECT_EQ(number_at(track, 3), 7);
}

TEST(AnimationTrack, StepsHoldUntilTheNextKeyAndMayBeAnything) {
  const Track track = track_in(R"("keys":[[0,"red"],[1,{"color":1}]],"interpolation":"step")");
  EXPECT_EQ(valued(track, 0.999), Value("red"));
  EXPECT_EQ(valued(track, 1), Value(Value::Object{{"color", 1}}));
}

// The cubics s^3, 1 - (1 - s)^3 and both halves of them, at 1/4 and 3/4 of the way.
TEST(AnimationTrack, EasesByCubics) {
  const auto eased_at = [](const char* ease, double time) {
    return number_at(track_in(R"("keys":[[0,0,")" + std::string(ease) + R"("],[1,64]])"), time);
  };
  EXPECT_EQ(eased_at("none", 0.25), 16);
  EXPECT_EQ(eased_at("in", 0.25), 1);
  EXPECT_EQ(eased_at("in", 0.75), 27);
  EXPECT_EQ(eased_at("out", 0.25), 64 - 27);
  EXPECT_EQ(eased_at("out", 0.75), 64 - 1);
  EXPECT_EQ(eased_at("in_out", 0.25), 4);
  EXPECT_EQ(eased_at("in_out", 0.5), 32);
  EXPECT_EQ(eased_at("in_out", 0.75), 60);
}

// ---- curves ---------------------------------------------------------------------------------

// A cubic is given by its values and slopes at two times: here those of c3 t^3 + c2 t^2 + c1 t +
// c0.
TEST(AnimationTrack, BezierIsTheCubicWithThoseTangents) {
  test::Random random(2);
  for (int i = 0; i < 100; ++i) {
    const double c3 = random.in(-2, 2), c2 = random.in(-2, 2), c1 = random.in(-2, 2);
    const double c0 = random.in(-2, 2), from = random.in(-3, 3), to = from + random.in(0.1, 3);
    const auto p = [&](double t) { return ((c3 * t + c2) * t + c1) * t + c0; };
    const auto slope = [&](double t) { return (3 * c3 * t + 2 * c2) * t + c1; };
    const auto key = [&](double t) { return to_json(Value::Array{t, p(t), slope(t), slope(t)}); };
    const Track track =
        track_in(R"("interpolation":"bezier","keys":[)" + key(from) + "," + key(to) + "]");
    const double t = random.in(from, to);
    EXPECT_NEAR(number_at(track, t), p(t), 1e-11);
  }
}

TEST(AnimationTrack, SmoothNumbersStayMonotoneAndWithinTheirKeys) {
  test::Random random(3);
  for (int i = 0; i < 40; ++i) {
    std::string text;
    double time = 0, value = 0;
    const int count = random.whole(2, 7);
    for (int k = 0; k < count; ++k) {
      text += (k > 0 ? "," : "") + key_text(time, value);
      time += random.in(0.01, 1);
      value += random.chance(0.3) ? 0 : random.chance(0.5) ? random.in(0, 100) : random.in(0, 0.1);
    }
    const Track track = track_in(R"("interpolation":"smooth","keys":[)" + text + "]");
    double before = number_at(track, 0);
    for (int step = 0; step < 300; ++step) {
      const double now = number_at(track, time * step / 300);
      EXPECT_GE(now, before) << text << " at step " << step;
      before = now;
    }
  }
}

// Where the data are a line, both splines are it.
TEST(AnimationTrack, SmoothKeepsLines) {
  const Track numbers = track_in(R"("interpolation":"smooth","keys":[[0,0],[1,2],[3,6],[4,8]])");
  const Track points = track_in(
      R"("interpolation":"smooth","keys":[[0,[0,0,0]],[1,[1,2,3]],[2,[2,4,6]],[3,[3,6,9]]])");
  for (int step = 0; step < 48; ++step) {
    const double t = step / 16.0;
    EXPECT_NEAR(number_at(numbers, t), 2 * t, 1e-14);
    const auto p = list_at(points, t);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(p[i], t * double(i + 1), 1e-14);
  }
}

// Barry and Goldman's pyramid (1988): three rounds of straight lines between knots whose distances
// are the roots of those of the points.
TEST(AnimationTrack, SmoothPointsAreTheCentripetalCatmullRomSpline) {
  test::Random random(4);
  for (int i = 0; i < 60; ++i) {
    const RandomKeys keys(random, 4, 3);
    const auto point = [&](std::size_t k) -> Vec3d {
      const auto& list = *keys.values[k].as<Value::Array>();
      return {*list[0].as<double>(), *list[1].as<double>(), *list[2].as<double>()};
    };
    std::array<double, 4> knot{};
    for (std::size_t k = 1; k < 4; ++k)
      knot[k] = knot[k - 1] + std::sqrt(length(point(k) - point(k - 1)));
    const double share = random.unit(), t = knot[1] + share * (knot[2] - knot[1]);
    const auto between = [&](const Vec3d& a, const Vec3d& b, std::size_t from, std::size_t to) {
      const double s = (t - knot[from]) / (knot[to] - knot[from]);
      return a * (1 - s) + b * s;
    };
    const Vec3d a1 = between(point(0), point(1), 0, 1), a2 = between(point(1), point(2), 1, 2);
    const Vec3d a3 = between(point(2), point(3), 2, 3);
    const Vec3d b1 = between(a1, a2, 0, 2), b2 = between(a2, a3, 1, 3);
    const Vec3d expected = between(b1, b2, 1, 2);
    const Track track = track_in(keys.text + R"(,"interpolation":"smooth")");
    const auto p = list_at(track, keys.times[1] + share * (keys.times[2] - keys.times[1]));
    EXPECT_LT(length(Vec3d{p[0], p[1], p[2]} - expected), 1e-11);
  }
}

TEST(AnimationTrack, SmoothColoursLeaveNoRangeOfTheirKeys) {
  const Track track =
      track_in(R"("interpolation":"smooth","keys":[[0,[1,1,1]],[1,[0,0,0]],[2,[0,1,0]]])");
  for (int step = 0; step <= 200; ++step)
    for (const double each : list_at(track, step / 100.0, TrackTarget::color)) {
      EXPECT_GE(each, 0);
      EXPECT_LE(each, 1);
    }
  double least = 0;  // as points they would
  for (int step = 0; step <= 200; ++step) least = std::min(least, list_at(track, step / 100.0)[1]);
  EXPECT_LT(least, -0.005);
}

// ---- repeats --------------------------------------------------------------------------------

TEST(AnimationTrack, LoopsAndGoesBackAndForth) {
  const std::string keys = R"("keys":[[1,10],[3,14]])";
  const Track loop = track_in(keys + R"(,"repeat":"loop")");
  const Track pingpong = track_in(keys + R"(,"repeat":"pingpong")");
  EXPECT_EQ(number_at(loop, 2), 12);
  EXPECT_EQ(number_at(loop, 3), 10);
  EXPECT_EQ(number_at(loop, 4.5), 13);
  EXPECT_EQ(number_at(loop, 0.5), 13);
  EXPECT_EQ(number_at(pingpong, 3), 14);
  EXPECT_EQ(number_at(pingpong, 3.5), 13);
  EXPECT_EQ(number_at(pingpong, 5), 10);
  EXPECT_EQ(number_at(pingpong, 5.5), 11);
  EXPECT_EQ(number_at(pingpong, 0.5), 11);
}

// Left and right of the join value and slope are the same: differences over 1e-5 s.
TEST(AnimationTrack, SmoothLoopsJoin) {
  const Track points = track_in(
      R"("interpolation":"smooth","repeat":"loop",
         "keys":[[0,[1,0,0]],[1,[0,0,1]],[2,[-1,0,0]],[3,[0,0,-1]],[4,[1,0,0]]])");
  const Track numbers =
      track_in(R"("interpolation":"smooth","repeat":"loop","keys":[[0,2],[1,5],[2,-1],[3,2]])");
  const double h = 1e-5;
  for (std::size_t i = 0; i < 3; ++i) {
    const double before = list_at(points, 4 - h)[i], at = list_at(points, 4)[i];
    EXPECT_NEAR((at - before) / h, (list_at(points, 4 + h)[i] - at) / h, 1e-3);
  }
  const double before = number_at(numbers, 3 - h), at = number_at(numbers, 3);
  EXPECT_NEAR((at - before) / h, (number_at(numbers, 3 + h) - at) / h, 1e-3);
  EXPECT_GT((at - before) / h, 0.5) << "it is no halt";
}

// ---- quaternions, formulas ------------------------------------------------------------------

// About z by 0 and 120 degrees, the second written as -q: between them the angle grows with time.
TEST(AnimationTrack, QuaternionsTurnAtConstantSpeedTheShortWay) {
  const double s = sin_of(pi / 3), c = cos_of(pi / 3);
  for (const double side : {1.0, -1.0}) {
    const Track track = track_in(R"("keys":[[0,[0,0,0,1]],)" +
                                 key_text(2, Value::Array{0, 0, side * s, side * c}) + "]");
    for (int step = 0; step < 16; ++step) {
      const double t = step / 8.0;
      const auto q = list_at(track, t, TrackTarget::quaternion);
      EXPECT_NEAR(q[2], sin_of(t * pi / 6), 1e-14);
      EXPECT_NEAR(q[3], cos_of(t * pi / 6), 1e-14);
    }
  }
}

TEST(AnimationTrack, FormulasAreOfTimeAndParameters) {
  const Track number = track_in(R"("formula":"72*t + a","parameters":{"a":0.5})");
  EXPECT_EQ(number_at(number, 2), 144.5);
  const Track list = track_in(R"("formula":["0","t^2","-t"])");
  EXPECT_EQ(list_at(list, 3), (std::vector<double>{0, 9, -3}));
  EXPECT_FALSE(value_at(track_in(R"x("formula":"sqrt(1-t)")x"), TrackTarget::numbers, 1.2));
  EXPECT_FALSE(value_at(track_in(R"("formula":"1/t")"), TrackTarget::numbers, 0));
}

TEST(AnimationTrack, VisibleIntervalsAreHalfOpen) {
  const Track track = track_in(R"("visible":[[1.5,4],[5,6]])");
  for (const double there : {1.5, 3.999, 5.0}) EXPECT_TRUE(track.is_visible(there));
  for (const double gone : {0.0, 1.499, 4.0, 6.0}) EXPECT_FALSE(track.is_visible(gone));
}

}  // namespace
}  // namespace tia
