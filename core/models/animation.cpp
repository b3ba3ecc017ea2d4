#include "core/models/animation.h"

#include <algorithm>

#include "core/math/quaternion.h"

namespace tia {
namespace {

using ChannelNumbers = std::vector<double>;

// Where a time falls among the keys: between `key` and the next, `share` of the way.
struct KeyTime {
  std::size_t key = 0;
  double share = 0, length = 0;  // of the span, in seconds
};

KeyTime key_time_of(const std::vector<float>& times, double seconds) {
  if (!(seconds > times.front())) return {};
  const auto after = std::ranges::upper_bound(times, seconds);
  const auto key = static_cast<std::size_t>(after - times.begin()) - 1;
  if (after == times.end()) return {key};
  const double from = times[key], to = *after;
  return {key, (seconds - from) / (to - from), to - from};
}

Quaternion quaternion_of(const ChannelNumbers& q) { return {q[0], q[1], q[2], q[3]}; }
ChannelNumbers numbers_of(const Quaternion& q) { return {q.begin(), q.end()}; }

// `which` of a key's n numbers: of a cubic spline 0 its in-tangent, 1 its value, 2 its out-tangent.
ChannelNumbers numbers_at(const AnimationChannel& channel, std::size_t key, std::size_t which,
                          std::size_t n) {
  const bool cubic = channel.interpolation == Interpolation::cubic_spline;
  const auto first =
      channel.values.begin() + static_cast<std::ptrdiff_t>((cubic ? 3 * key + which : key) * n);
  return {first, first + static_cast<std::ptrdiff_t>(n)};
}

ChannelNumbers cubic_at(const AnimationChannel& channel, const KeyTime& at, std::size_t n) {
  const double t = at.share, tt = t * t, ttt = tt * t;
  const ChannelNumbers p = numbers_at(channel, at.key, 1, n), m = numbers_at(channel, at.key, 2, n);
  const ChannelNumbers q = numbers_at(channel, at.key + 1, 1, n);
  const ChannelNumbers k = numbers_at(channel, at.key + 1, 0, n);
  ChannelNumbers out(n);
  for (std::size_t i = 0; i < n; ++i)
    out[i] = (2 * ttt - 3 * tt + 1) * p[i] + (ttt - 2 * tt + t) * (at.length * m[i]) +
             (3 * tt - 2 * ttt) * q[i] + (ttt - tt) * (at.length * k[i]);
  return out;
}

ChannelNumbers linear_at(const AnimationChannel& channel, const KeyTime& at, std::size_t n) {
  ChannelNumbers a = numbers_at(channel, at.key, 1, n);
  const ChannelNumbers b = numbers_at(channel, at.key + 1, 1, n);
  if (channel.path == AnimatedPath::rotation)
    return numbers_of(slerp(quaternion_of(a), quaternion_of(b), at.share));
  for (std::size_t i = 0; i < n; ++i) a[i] += at.share * (b[i] - a[i]);
  return a;
}

}  // namespace

double duration_of(const ModelAnimation& animation) {
  double seconds = 0;
  for (const AnimationChannel& each : animation.channels)
    if (!each.times.empty()) seconds = std::max<double>(seconds, each.times.back());
  return seconds;
}

std::vector<double> sampled(const AnimationChannel& channel, double seconds) {
  const KeyTime at = key_time_of(channel.times, seconds);
  const std::size_t each = channel.values.size() / channel.times.size();
  const bool cubic = channel.interpolation == Interpolation::cubic_spline;
  const std::size_t n = cubic ? each / 3 : each;
  const bool between = at.share > 0 && channel.interpolation != Interpolation::step;
  ChannelNumbers out = !between ? numbers_at(channel, at.key, 1, n)
                       : cubic  ? cubic_at(channel, at, n)
                                : linear_at(channel, at, n);
  if (channel.path == AnimatedPath::rotation) out = numbers_of(normalized(quaternion_of(out)));
  return out;
}

}  // namespace tia
