#include "core/scene/animation_track.h"

#include <algorithm>
#include <cmath>

#include "core/formulas/parse.h"
#include "core/math/quaternion.h"
#include "core/scene/animation_curves.h"

namespace tia {
namespace {

using TrackKeys = std::vector<AnimationKey>;

TrackNumbers numbers_of_value(const Value& value) {
  if (const auto* number = value.as<double>()) return {*number};
  TrackNumbers out;
  for (const Value& each : *value.as<Value::Array>()) out.push_back(*each.as<double>());
  return out;
}

Value value_of_numbers(const TrackNumbers& numbers, bool is_list) {
  if (!is_list) return numbers.front();
  return Value::Array(numbers.begin(), numbers.end());
}

// The time among the keys, after the repeat: within their span, or as it is.
double time_among(const TrackKeys& keys, KeyRepeat repeat, double seconds) {
  const double first = keys.front().time, span = keys.back().time - first;
  if (repeat == KeyRepeat::once || !(span > 0)) return seconds;
  const double last = keys.back().time;  // of a loop the first again
  if (first <= seconds && (seconds < last || (seconds == last && repeat == KeyRepeat::pingpong)))
    return seconds;
  const double period = repeat == KeyRepeat::loop ? span : 2 * span;
  const double passed = seconds - first;
  double into = std::clamp(passed - period * std::floor(passed / period), 0.0, period);
  if (repeat == KeyRepeat::loop && into == period) into = 0;
  return first + (into <= span ? into : period - into);
}

TrackKnot knot_of(const AnimationKey& key, double time) {
  return {time, numbers_of_value(*key.value)};
}

/// The keys around two neighbours, as the repeat has them.
class Neighbours {
 public:
  Neighbours(const TrackKeys& keys, KeyRepeat repeat)
      : keys_(keys),
        repeat_(repeat),
        closed_(repeat == KeyRepeat::loop && *keys.front().value == *keys.back().value) {}

  std::optional<TrackKnot> before(std::size_t i) const {
    if (i > 0) return knot_of(keys_[i - 1], keys_[i - 1].time);
    const double first = keys_.front().time;
    if (repeat_ == KeyRepeat::pingpong) return knot_of(keys_[1], 2 * first - keys_[1].time);
    if (!closed_) return std::nullopt;
    const AnimationKey& last = keys_.back();
    const AnimationKey& previous = keys_[keys_.size() - 2];
    return knot_of(previous, first - (last.time - previous.time));
  }
  std::optional<TrackKnot> after(std::size_t i) const {
    if (i + 1 < keys_.size()) return knot_of(keys_[i + 1], keys_[i + 1].time);
    const double last = keys_.back().time;
    const AnimationKey& previous = keys_[keys_.size() - 2];
    if (repeat_ == KeyRepeat::pingpong) return knot_of(previous, 2 * last - previous.time);
    if (!closed_) return std::nullopt;
    return knot_of(keys_[1], last + (keys_[1].time - keys_.front().time));
  }

 private:
  const TrackKeys& keys_;
  KeyRepeat repeat_;
  bool closed_;
};

TrackNumbers smooth_between(TrackSpan span, std::size_t from, const Track& track,
                            TrackTarget target) {
  if (target == TrackTarget::quaternion) return slerp_between(span);
  const Neighbours around(*track.keys, track.repeat);
  span.before = around.before(from);
  span.after = around.after(from + 1);
  const bool point = span.from.value.size() == 3 && target == TrackTarget::numbers;
  return point ? catmull_rom_between(span) : monotone_between(span);
}

TrackNumbers bezier_between(const TrackSpan& span, const AnimationKey& from, const AnimationKey& to,
                            TrackTarget target) {
  TrackNumbers out =
      hermite_between(span, numbers_of_value(**from.after), numbers_of_value(**to.before));
  if (target != TrackTarget::quaternion) return out;
  const Quaternion q = normalized({out[0], out[1], out[2], out[3]});
  return {q.begin(), q.end()};
}

Value keyed_value(const Track& track, TrackTarget target, double seconds) {
  const TrackKeys& keys = *track.keys;
  const double time = time_among(keys, track.repeat, seconds);
  const auto later = std::ranges::upper_bound(keys, time, {}, &AnimationKey::time);
  if (later == keys.begin()) return *keys.front().value;
  const AnimationKey& from = *(later - 1);
  const bool between = later != keys.end() && time > from.time;
  if (!between || track.interpolation == KeyInterpolation::step) return *from.value;
  if (target == TrackTarget::quaternion && numbers_of_value(*from.value).size() != 4)
    target = TrackTarget::numbers;  // which the scene's reader will refuse
  const double share = (time - from.time) / (later->time - from.time);
  const TrackSpan span{
      knot_of(from, from.time), knot_of(*later, later->time), {}, {}, eased(share, from.ease)};
  const auto numbers = [&] {
    switch (track.interpolation) {
      case KeyInterpolation::smooth:
        return smooth_between(span, static_cast<std::size_t>(&from - keys.data()), track, target);
      case KeyInterpolation::bezier: return bezier_between(span, from, *later, target);
      default: break;
    }
    return target == TrackTarget::quaternion ? slerp_between(span) : linear_between(span);
  }();
  return value_of_numbers(numbers, from.value->as<Value::Array>() != nullptr);
}

std::optional<Value> formula_value(const Track& track, double seconds) {
  const auto& parts = track.formula->parts;
  const Program program = program_of({parts.begin(), parts.end()}, track.formula_names());
  WhereOf<double> where;
  const double* const slots = run(program, &seconds, where);
  TrackNumbers numbers;
  for (const std::uint16_t slot : program.results) numbers.push_back(slots[slot]);
  if (!std::ranges::all_of(numbers, [](double each) { return std::isfinite(each); }))
    return std::nullopt;
  return value_of_numbers(numbers, track.formula->is_list);
}

}  // namespace

double own_time(const Animation& animation, const Track& track, double seconds) {
  return track.repeat != KeyRepeat::once ? seconds : std::clamp(seconds, 0.0, animation.duration);
}

std::optional<Value> value_at(const Track& track, TrackTarget target, double seconds) {
  if (track.formula) return formula_value(track, seconds);
  return keyed_value(track, target, seconds);
}

}  // namespace tia
