// How a test sends a line through a form, and the laws that hold between a form and an independent
// implicit function of it: below 0 inside, above 0 outside, near the surface a distance.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "core/input/codec.h"
#include "core/shapes/crossing.h"
#include "tests/core/faults.h"
#include "tests/core/support.h"

namespace tia::test {

using Vec3l = Vec3<Long>;

constexpr double scales[] = {1e-3, 1, 1e3};

inline Bounds box_of(const Vec3d& min, const Vec3d& max) {
  Bounds b;
  b.min = min, b.max = max;
  return b;
}
inline Bounds cube_of(double half, const Vec3d& center = {0, 0, 0}) {
  return box_of(center - Vec3d{half, half, half}, center + Vec3d{half, half, half});
}
inline Bounds ball_of(double radius, const Vec3d& center = {0, 0, 0}) {
  Bounds b;
  b.center = center, b.radius = radius;
  return b;
}

/// A line of the scene: its direction has any length, and t counts such lengths.
struct SceneLine {
  Vec3d origin, direction;
  Vec3l at(Long t) const { return static_cast<Vec3l>(origin) + static_cast<Vec3l>(direction) * t; }
};

/// All that `send(line, emit)` emits for the line, made ready as the tracer does it: the direction
/// of length 1, the origin next to the middle of the bounds.
template <class Send>
std::vector<Crossing> sent(const Aabb& box, const SceneLine& scene, Send send) {
  const double size = length(scene.direction);
  const Vec3d direction = scene.direction * (1 / size);
  const Vec3d middle = box.bounded() ? box.center() : Vec3d{0, 0, 0};
  const double shift = dot(middle - scene.origin, direction);
  std::vector<Crossing> all;
  send(Line{scene.origin + direction * shift, direction}, [&](double t, int element) {
    all.push_back({(t + shift) / size, element});
  });
  return all;
}
template <class Form>
std::vector<Crossing> crossings_along(const Form& form, const SceneLine& line) {
  return sent(bounds(form), line, [&](const Line& l, auto emit) { crossings(form, l, emit); });
}
/// Its distances only.
template <class Form>
std::vector<double> roots_along(const Form& form, const SceneLine& line) {
  std::vector<double> all;
  for (const Crossing& each : crossings_along(form, line)) all.push_back(each.t);
  return all;
}

template <class Form>
std::vector<Crossing> spans_along(const Form& form, const SceneLine& line) {
  return sent(bounds(form), line, [&](const Line& l, auto emit) { spans(form, l, emit); });
}
inline std::vector<double> ends_of(const std::vector<Crossing>& all) {
  std::vector<double> t;
  for (const Crossing& each : all) t.push_back(each.t);
  return t;
}
/// How much work the form's crossings take, the line sent as it is.
template <class Form>
std::int64_t work_along(const Form& form, const SceneLine& line) {
  return crossings(form, Line{line.origin, line.direction}, [](double, int) {});
}

inline void expect_distances(const std::vector<double>& got, const std::vector<double>& expected,
                             double tolerance, const std::string& what = "") {
  ASSERT_EQ(got.size(), expected.size()) << what << testing::PrintToString(got);
  for (std::size_t i = 0; i < got.size(); ++i) {
    if (std::isinf(expected[i])) EXPECT_EQ(got[i], expected[i]) << what;
    else EXPECT_NEAR(got[i], expected[i], tolerance) << what;
  }
}

/// A line from around a ball towards it more often than not.
inline SceneLine line_near(Random& random, const Vec3d& center, double size) {
  const Vec3d origin = center + random.vector(0, 4 * size);
  const Vec3d target = center + random.vector(0, 1.2 * size);
  return {origin, (target - origin) * random.in(0.1, 10)};
}

/// The gradient of f by central differences; nothing where f has an edge.
template <class Implicit>
std::optional<Vec3d> gradient(const Implicit& f, const Vec3l& p, Long step) {
  Vec3d g{};
  const Vec3l axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  double* const out[] = {&g.x, &g.y, &g.z};
  for (int i = 0; i < 3; ++i) {
    const Long ahead = f(p + axes[i] * step) - f(p), behind = f(p) - f(p - axes[i] * step);
    if (std::fabs(ahead - behind) > 1e-3L * step) return std::nullopt;
    *out[i] = static_cast<double>((ahead + behind) / (2 * step));
  }
  return g;
}

/// What every crossing obeys: it lies on the surface and in the bounds, its normal is the
/// gradient, its element and its uv are in their ranges. Returns: whether the normal was compared.
template <class Form, class Implicit>
bool expect_on_surface(const Form& form, const Implicit& f, const Vec3l& exact, int element,
                       double size, bool unit_uv = true) {
  const auto p = static_cast<Vec3d>(exact);
  EXPECT_LE(std::fabs(f(exact)), 1e-12L * size);
  EXPECT_TRUE(0 <= element && element < elements(form)) << element;
  const Aabb box = bounds(form);
  const double slack = 1e-12 * size;
  EXPECT_TRUE(p.x >= box.min.x - slack && p.y >= box.min.y - slack && p.z >= box.min.z - slack &&
              p.x <= box.max.x + slack && p.y <= box.max.y + slack && p.z <= box.max.z + slack);
  const Vec2d place = uv(form, p, element);
  EXPECT_TRUE(!unit_uv || (0 <= place.u && place.u <= 1 && 0 <= place.v && place.v <= 1))
      << place.u << " " << place.v;
  const Vec3d n = normal(form, p, element);
  EXPECT_NEAR(length(n), 1, 1e-14);
  const auto g = gradient(f, exact, 1e-5L * size);
  EXPECT_LT(g ? length(n - normalize(*g)) : 0, 1e-4);
  return g.has_value();
}

/// The laws of a solid's pairs along one line: ascending, and between in and out, there only, the
/// implicit function is below 0.
template <class Implicit>
void expect_pairs_hold(const std::vector<Crossing>& pairs, const Implicit& f, const SceneLine& line,
                       const Vec3d& center, double size) {
  ASSERT_EQ(pairs.size() % 2, 0u);
  for (std::size_t i = 1; i < pairs.size(); ++i) ASSERT_LE(pairs[i - 1].t, pairs[i].t);
  constexpr int steps = 60;
  const double pace = length(line.direction);
  const double middle = dot(center - line.origin, line.direction) / (pace * pace);
  for (int i = 0; i <= steps; ++i) {
    const double t = middle + (2.0 * i / steps - 1) * 2.2 * size / pace;
    bool inside = false;
    for (std::size_t k = 0; k < pairs.size(); k += 2)
      inside = inside || (pairs[k].t < t && t < pairs[k + 1].t);
    const Long value = f(line.at(t));
    if (std::fabs(value) <= 1e-9L * size) continue;
    ASSERT_EQ(inside, value < 0) << "t " << t << ", value " << value;
  }
}

/// Sends random lines through a solid of the given size around a centre and checks all of the
/// above. Returns: how many crossings there were.
template <class Form, class Implicit>
int expect_solid(const Form& form, const Implicit& f, const Vec3d& center, double size,
                 Random& random, bool unit_uv = true) {
  int seen = 0, compared = 0;
  for (int i = 0; i < 20; ++i) {
    const SceneLine line = line_near(random, center, size);
    const std::vector<Crossing> pairs = crossings_along(form, line);
    expect_pairs_hold(pairs, f, line, center, size);
    for (const Crossing& each : pairs) {
      if (!std::isfinite(each.t)) continue;
      ++seen;
      compared += expect_on_surface(form, f, line.at(each.t), each.element, size, unit_uv);
    }
  }
  EXPECT_GE(2 * compared, seen) << "hardly any normal was compared";
  return seen;
}

/// Lines of which some number is NaN cross nothing.
template <class Form>
void expect_nothing_from_nan(const Form& form) {
  const double nan = std::nan("");
  for (int i = 0; i < 7; ++i) {
    double n[] = {0.1, 0.2, 0.3, 0.6, 0, 0.8};
    for (int k = 0; k < 6; ++k)
      if (k == i || i == 6) n[k] = nan;
    crossings(form, Line{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}},
              [&](double t, int) { ADD_FAILURE() << "component " << i << " emits " << t; });
  }
}

/// The faults that a description of this kind is refused with.
template <class Kind>
std::vector<Fault> faults_in(const std::string& json) {
  return faults_of([&] { read_described<Kind>(parse_json(json)); });
}

}  // namespace tia::test
