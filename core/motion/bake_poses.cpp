#include "core/motion/bake_poses.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tia {
namespace {

using Numbers4 = std::array<double, 4>;  // of a point three, and 0

Numbers4 sum_of(const Numbers4& a, double s, const Numbers4& b, double t) {
  Numbers4 sum;
  for (std::size_t i = 0; i < 4; ++i) sum[i] = s * a[i] + t * b[i];
  return sum;
}
double distance(const Numbers4& a, const Numbers4& b) {
  double square = 0;
  for (std::size_t i = 0; i < 4; ++i) square += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(square);
}
Numbers4 unit_of(const Numbers4& q) { return normalized(q); }

/// SampledCurve: values at equal steps of time, as the fewest keys of a bezier track that a greedy
/// search finds. A key's tangents are those of the parabolas through the three steps that end and
/// begin there, so that free flight is one span, and a jump of the velocity is no wave.
class SampledCurve {
 public:
  SampledCurve(std::vector<double> times, std::vector<Numbers4> values, bool turns,
               double tolerance)
      : times_(std::move(times)),
        values_(std::move(values)),
        turns_(turns),
        tolerance_(tolerance) {}

  std::vector<AnimationKey> keys() const {
    std::vector<AnimationKey> keys{key(0)};
    for (std::size_t at = 0; at + 1 < values_.size();) {
      const std::size_t to = reach(at);
      keys.back().after = value(leaving(at, to));
      keys.push_back(key(to));
      keys.back().before = value(arriving(at, to));
      at = to;
    }
    return keys;
  }

 private:
  static constexpr std::size_t longest = 4096;

  SharedValue value(const Numbers4& of) const {
    Value::Array list(of.begin(), of.begin() + (turns_ ? 4 : 3));
    return Value(std::move(list));
  }
  AnimationKey key(std::size_t at) const {
    return {times_[at], value(values_[at]), Ease::none, value({}), value({})};
  }
  Numbers4 slope(std::size_t from, std::size_t to) const {
    const double passed = times_[to] - times_[from];
    return sum_of(values_[to], 1 / passed, values_[from], -1 / passed);
  }
  // A parabola's slope at its first point is twice the first step's less that of both.
  Numbers4 leaving(std::size_t from, std::size_t to) const {
    if (to == from + 1) return slope(from, to);
    return sum_of(slope(from, from + 1), 2, slope(from, from + 2), -1);
  }
  Numbers4 arriving(std::size_t from, std::size_t to) const {
    if (to == from + 1) return slope(from, to);
    return sum_of(slope(to - 1, to), 2, slope(to - 2, to), -1);
  }

  // Whether a span keeps to what it leaves out.
  bool fits(std::size_t from, std::size_t to) const {
    const double passed = times_[to] - times_[from];
    const Numbers4 out = leaving(from, to), in = arriving(from, to);
    for (std::size_t k = from + 1; k < to; ++k) {
      const double s = (times_[k] - times_[from]) / passed, r = 1 - s;
      const Numbers4 ends =
          sum_of(values_[from], r * r * (1 + 2 * s), values_[to], s * s * (3 - 2 * s));
      const Numbers4 bends = sum_of(out, passed * s * r * r, in, -passed * s * s * r);
      const Numbers4 at = sum_of(ends, 1, bends, 1);
      if (!(distance(turns_ ? unit_of(at) : at, values_[k]) <= tolerance_)) return false;
    }
    return true;
  }

  // The farthest key from there that a doubling and then halving search finds.
  std::size_t reach(std::size_t from) const {
    const std::size_t last = std::min(values_.size() - 1, from + longest);
    std::size_t good = from + 1, step = 1;
    while (good < last && fits(from, std::min(good + step, last))) {
      good = std::min(good + step, last);
      step *= 2;
    }
    for (; step > 0; step /= 2)
      if (good + step <= last && fits(from, good + step)) good += step;
    return good;
  }

  std::vector<double> times_;
  std::vector<Numbers4> values_;
  bool turns_;
  double tolerance_;
};

Track track_of(const std::string& target, std::vector<AnimationKey> keys) {
  Track track;
  track.target = target;
  track.interpolation = KeyInterpolation::bezier;
  track.keys = std::move(keys);
  return track;
}

// A turn about the scene's axes as one about the axes of a space in it. An axis that a mirror shows
// turns the other way.
Numbers4 turned_in(const Affine& inner, const Quaternion& q) {
  const Vec3d axis = inner.vector(Vec3d{q[0], q[1], q[2]}) * (inner.determinant() < 0 ? -1.0 : 1.0);
  return normalized({axis.x, axis.y, axis.z, q[3]});
}

}  // namespace

void bake_poses(const PlacedObject& object, const std::vector<RigidPose>& poses, double radius,
                double tolerance, Simulation& into) {
  const Affine inner = object.parent.inverse();
  const Vec3d start = poses.front().center, center = inner.point(start);
  std::vector<double> times;
  std::vector<Numbers4> ways, turns;
  for (const RigidPose& pose : poses) {
    times.push_back(pose.time);
    const Vec3d way = inner.vector(pose.center - start);
    ways.push_back({way.x, way.y, way.z, 0});
    Numbers4 turn = turns.empty() ? Numbers4{0, 0, 0, 1} : turned_in(inner, pose.rotation);
    if (!turns.empty() && distance(turn, turns.back()) > 1) turn = sum_of(turn, -1, turn, 0);
    turns.push_back(turn);
  }
  const std::string steps = pointer_of(object.path) + "/transform/";
  const std::size_t own = object.object->transform.steps.size();
  into.steps.push_back(
      {object.path, {Translate{-center}, RotateQuaternion{}, Translate{center}, Translate{}}});
  into.tracks.push_back(
      track_of(steps + std::to_string(own + 1) + "/rotate_quaternion",
               SampledCurve(times, std::move(turns), true, tolerance / (2 * radius)).keys()));
  into.tracks.push_back(
      track_of(steps + std::to_string(own + 3) + "/translate",
               SampledCurve(std::move(times), std::move(ways), false, tolerance).keys()));
}

}  // namespace tia
