#include "core/scene/animation_curves.h"

#include <algorithm>
#include <cmath>

#include "core/math/quaternion.h"

namespace tia {

double eased(double share, Ease ease) {
  const double left = 1 - share;
  switch (ease) {
    case Ease::none: break;
    case Ease::in: return share * share * share;
    case Ease::out: return 1 - left * left * left;
    case Ease::in_out: return share < 0.5 ? 4 * share * share * share : 1 - 4 * left * left * left;
  }
  return share;
}

TrackNumbers linear_between(const TrackSpan& span) {
  TrackNumbers out = span.from.value;
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] += (span.to.value[i] - span.from.value[i]) * span.share;
  return out;
}

namespace {

// Hermite's cubic from p to q with tangents a unit of the share.
double hermite(double p, double m, double q, double k, double t) {
  const double tt = t * t, ttt = tt * t;
  return (2 * ttt - 3 * tt + 1) * p + (ttt - 2 * tt + t) * m + (3 * tt - 2 * ttt) * q +
         (ttt - tt) * k;
}

// The root of the distance: the centripetal parameter's step.
double knot_step(const TrackKnot& a, const TrackKnot& b) {
  double square = 0;
  for (std::size_t i = 0; i < a.value.size(); ++i) {
    const double d = b.value[i] - a.value[i];
    square += d * d;
  }
  return std::sqrt(std::sqrt(square));
}

// The slope between two keys.
double secant(const TrackKnot& a, const TrackKnot& b, std::size_t i) {
  return (b.value[i] - a.value[i]) / (b.time - a.time);
}

// At a key between two others: the parabola's, kept within what is monotone.
double monotone_slope(const TrackKnot& before, const TrackKnot& at, const TrackKnot& after,
                      std::size_t i) {
  const double left = secant(before, at, i), right = secant(at, after, i);
  if (!(left * right > 0)) return 0;
  const double h = at.time - before.time, k = after.time - at.time;
  const double slope = (k * left + h * right) / (h + k);
  const double most = 3 * std::min(std::fabs(left), std::fabs(right));
  return std::clamp(slope, -most, most);
}

}  // namespace

TrackNumbers hermite_between(const TrackSpan& span, const TrackNumbers& leaving,
                             const TrackNumbers& arriving) {
  const double length = span.to.time - span.from.time;
  TrackNumbers out(span.from.value.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = hermite(span.from.value[i], length * leaving[i], span.to.value[i],
                     length * arriving[i], span.share);
  return out;
}

TrackNumbers catmull_rom_between(const TrackSpan& span) {
  const double step = knot_step(span.from, span.to);
  if (step == 0) return span.from.value;
  const double before = span.before ? knot_step(*span.before, span.from) : 0;
  const double after = span.after ? knot_step(span.to, *span.after) : 0;
  TrackNumbers out(span.from.value.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double p = span.from.value[i], q = span.to.value[i];
    double m = q - p, k = q - p;
    if (before > 0) {
      const double o = span.before->value[i];
      m = step * ((p - o) / before - (q - o) / (before + step) + (q - p) / step);
    }
    if (after > 0) {
      const double r = span.after->value[i];
      k = step * ((q - p) / step - (r - p) / (step + after) + (r - q) / after);
    }
    out[i] = hermite(p, m, q, k, span.share);
  }
  return out;
}

TrackNumbers monotone_between(const TrackSpan& span) {
  TrackNumbers leaving(span.from.value.size()), arriving(leaving.size());
  for (std::size_t i = 0; i < leaving.size(); ++i) {
    leaving[i] = span.before ? monotone_slope(*span.before, span.from, span.to, i)
                             : secant(span.from, span.to, i);
    arriving[i] = span.after ? monotone_slope(span.from, span.to, *span.after, i)
                             : secant(span.from, span.to, i);
  }
  TrackNumbers out = hermite_between(span, leaving, arriving);
  // What rounding may take out of the range of the two keys.
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto [least, most] = std::minmax(span.from.value[i], span.to.value[i]);
    out[i] = std::clamp(out[i], least, most);
  }
  return out;
}

TrackNumbers slerp_between(const TrackSpan& span) {
  const auto quaternion_in = [](const TrackNumbers& q) -> Quaternion {
    return {q[0], q[1], q[2], q[3]};
  };
  const Quaternion q =
      slerp(quaternion_in(span.from.value), quaternion_in(span.to.value), span.share);
  return {q.begin(), q.end()};
}

}  // namespace tia
