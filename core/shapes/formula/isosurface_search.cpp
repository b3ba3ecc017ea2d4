#include "core/shapes/formula/isosurface_search.h"

#include <algorithm>
#include <cmath>

#include "core/shapes/formula/isosurface_root.h"

namespace tia::detail {
namespace {

// The budget of one line, in evaluations of eight stretches. One stretch may take a share of what
// is left, so that the first ones leave some for those behind, and at least enough to find one
// jump.
constexpr int most_eights = 2000, stretch_share = 4, least_eights = 24, last_eights = 8000;
constexpr std::string_view proven = "interval arithmetic proves the slope to be nowhere 0";
constexpr std::string_view bisected = "bisected as far as the numbers tell apart";
constexpr std::string_view touching = "touches 0, to rounding, and turns back";

}  // namespace

// ---- the function along the line ---------------------------------------------------------------

double IsosurfaceLine::value(double t) const {
  const Vec3d p = line_.at(t);
  const std::array<double, 3> variables{p.x, p.y, p.z};
  return evaluate(function_, variables.data());
}

Dual<Interval<Octet>, 1> IsosurfaceLine::over(const Interval<Octet>& t,
                                              Definedness<Octet>& where) const {
  using I = Interval<Octet>;
  const Vec3d &o = line_.origin, &d = line_.direction;
  const auto along = [&](double from, double way) {
    if (way == 0) return Dual<I, 1>{I(from), {I(0.0)}};  // exactly, in a plane of jumps, say
    return Dual<I, 1>{I(from) + I(way) * t, {I(way)}};
  };
  const std::array<Dual<I, 1>, 3> variables{along(o.x, d.x), along(o.y, d.y), along(o.z, d.z)};
  return evaluate(function_, variables.data(), where);
}

Interval<Octet> IsosurfaceLine::at(const Octet& t, Definedness<Octet>& where) const {
  using I = Interval<Octet>;
  const Vec3d &o = line_.origin, &d = line_.direction;
  const auto along = [&](double from, double way) {
    return way == 0 ? I(from) : I(from) + I(way) * I(t, t);
  };
  const std::array<I, 3> variables{along(o.x, d.x), along(o.y, d.y), along(o.z, d.z)};
  return evaluate(function_, variables.data(), where);
}

// ---- pieces of the line ---------------------------------------------------------------------

/// Piece: a stretch of the line with what is known of the function there.
struct IsosurfaceSearch::Piece {
  enum Kind { outside, inside, monotone, unknown, least } kind = unknown;
  double from = 0, to = 0;
  bool smooth = false;
};

/// Pieces: a stack of pieces to be searched, the nearest on top. One is replaced by eight; the
/// smallest are 2^-42 of the first.
class IsosurfaceSearch::Pieces {
 public:
  bool empty() const { return count_ == 0; }
  void push(const Piece& piece) { all_[count_++] = piece; }
  Piece pop() { return all_[--count_]; }

 private:
  std::array<Piece, 128> all_;
  std::size_t count_ = 0;
};

/// Eight: what intervals say of eight stretches.
struct IsosurfaceSearch::Eight {
  Octet low, high;  ///< f
  Octet noise;      ///< a bound of the rounding error of f
  Octet slope_low, slope_high;
  Definedness<Octet> where;

  Eight(const IsosurfaceLine& along, const Interval<Octet>& t) {
    const auto over = along.over(t, where);
    const Octet middle = t.middle();
    Definedness<Octet> there;
    const Interval<Octet> value = along.at(middle, there);
    const Interval<Octet> range =
        value + over.slope[0] * Interval<Octet>(interval::down(Octet(t.lo - middle)),
                                                interval::up(Octet(t.hi - middle)));
    where.whole = where.whole && there.whole;
    // By the mean value theorem; a comparison with NaN leaves the function's own interval.
    low = select(where.whole, max_of(range.lo, over.value.lo), over.value.lo);
    high = select(where.whole, min_of(range.hi, over.value.hi), over.value.hi);
    noise = value.width();
    slope_low = over.slope[0].lo;
    slope_high = over.slope[0].hi;
  }
  Piece::Kind kind(int i, double width, double least) const {
    const bool some = lane_of(where.some, i), whole = lane_of(where.whole, i);
    const double from = lane(low, i), to = lane(high, i);
    if (!some || from > 0) return Piece::outside;
    if (to < 0 && whole) return Piece::inside;
    if (whole && (lane(slope_low, i) > 0 || lane(slope_high, i) < 0)) return Piece::monotone;
    const double blur = 8 * lane(noise, i);
    if (!(width > least) || (whole && from >= -blur && to <= blur)) return Piece::least;
    return Piece::unknown;
  }
  static bool lane_of(const OctetMask& mask, int i) { return (bits(mask) >> i & 1) != 0; }
};

// ---- the search -----------------------------------------------------------------------------

IsosurfaceSearch::IsosurfaceSearch(const Program& function, const Line& line, double reach,
                                   IsosurfaceListener& listener, bool brackets_alone)
    : along_(function, line), listener_(listener), brackets_alone_(brackets_alone) {
  const Vec3d& o = line.origin;
  const double size = std::max({reach, std::fabs(o.x), std::fabs(o.y), std::fabs(o.z)});
  tolerance_ = 0x1p-52 * size;  // two roundings of a point's coordinate
  least_ = 0x1p-40 * reach;     // the smallest piece: roots are told apart down to it
}

std::int64_t IsosurfaceSearch::work() const {
  return (std::int64_t(values_) + 12 * std::int64_t(eights_)) * (1 + along_.cost() / 4);
}

// Where the function is smooth, its roots lie between two parallel planes. What of the stretch is
// beyond them has no root and a known sign.
bool IsosurfaceSearch::visit(const IsosurfaceCell& cell, const Vec3d& start, double in,
                             double out) {
  const double from = std::max(in, searched_);
  if (!(from <= out)) return true;
  searched_ = out;
  if (!cell.smooth) return part(from, out);
  const Vec3d& d = along_.direction();
  const double at_start = cell.offset + dot(cell.gradient, start), slope = dot(cell.gradient, d);
  double a = from, b = out;
  const double root = -at_start / slope, room = std::fabs(cell.slack / slope);
  if (root - room > a) a = root - room;
  if (root + room < b) b = root + room;
  if (slope == 0 && std::fabs(at_start) > cell.slack) return true;
  if (!(a <= b)) return true;
  const Vec3d spread = static_cast<Vec3d>(cell.spread);
  const double other = dot(spread, upper(d, -d)) * (1 + 0x1p-40);
  if (!(std::fabs(slope) > other)) {
    // The middle is farther from 0 than the function changes up to the ends.
    ++values_;
    const double farthest = (std::fabs(slope) + other) * (b - a) / 2;
    if (std::fabs(along_.value((a + b) / 2)) > farthest + cell.slack * 0x1p-20) return true;
    return part(a, b);
  }
  const bool rises = slope > 0;
  const bool inside_a = a > from ? rises : inside_before(a);
  if (inside_a != rises) return settle(a, inside_a);
  const bool inside_b = b < out ? !rises : inside_at(b);
  return cross_once(a, b, inside_a, inside_b, root, proven);
}

bool IsosurfaceSearch::part(double from, double to) {
  const int share = std::max(least_eights, (most_eights - eights_) / stretch_share);
  const int most = std::min(eights_ + share, last_eights);
  Pieces waiting;
  waiting.push({Piece::unknown, from, to, false});
  while (!waiting.empty()) {
    const Piece next = waiting.pop();
    if (next.kind == Piece::unknown && eights_ < most) part(next, waiting);
    else if (!finish(next)) return false;
  }
  return true;
}

void IsosurfaceSearch::part(const Piece& piece, Pieces& waiting) {
  ++eights_;
  std::array<double, 9> knots;
  for (std::size_t i = 0; i < 9; ++i)
    knots[i] = piece.from + (piece.to - piece.from) * (static_cast<double>(i) * 0.125);
  knots[8] = piece.to;
  const Eight eight(along_,
                    {Octet::load_unaligned(knots.data()), Octet::load_unaligned(knots.data() + 1)});
  for (int i = 8; i-- > 0;) {
    const auto at = static_cast<std::size_t>(i);
    const double width = knots[at + 1] - knots[at];
    waiting.push({eight.kind(i, width, least_), knots[at], knots[at + 1],
                  Eight::lane_of(eight.where.whole, i)});
  }
}

bool IsosurfaceSearch::finish(const Piece& piece) {
  switch (piece.kind) {
    case Piece::outside: return settle(piece.from, false);
    case Piece::inside: return settle(piece.from, true);
    case Piece::monotone: {
      const bool inside_from = inside_at(piece.from);
      return cross_once(piece.from, piece.to, inside_from, inside_at(piece.to),
                        (piece.from + piece.to) / 2, proven);
    }
    default: return finish_least(piece);
  }
}

bool IsosurfaceSearch::finish_least(const Piece& piece) {
  const bool inside_from = inside_at(piece.from), inside_to = inside_at(piece.to);
  if (inside_from != inside_to && !piece.smooth && !vanishes(piece))
    return settle(piece.from, inside_from) && settle(piece.to, inside_to);
  const double middle = (piece.from + piece.to) / 2;
  if (inside_from != inside_to)
    return cross_once(piece.from, piece.to, inside_from, inside_to, middle, bisected);
  if (piece.kind == Piece::unknown || !vanishes(piece)) return settle(piece.from, inside_from);
  const bool new_one = piece.from > touched_to_;
  touched_to_ = piece.to;
  if (!new_one || !settle(piece.from, inside_from)) return !new_one;
  const Bracket bracket{piece.from, piece.to, touching};
  return tell({middle, !inside_from, true, bracket}) && tell({middle, inside_from, true, bracket});
}

// Whether the function is nearly 0 at a piece's ends, compared with its values a little beyond
// them. That tells a root from a jump, and a touched 0 from where intervals prove nothing, as at 0
// / 0.
bool IsosurfaceSearch::vanishes(const Piece& piece) {
  // Compared with the values 2^20 pieces away, a root of the first order has 2^-20 of them here,
  // one where f goes with the square root of t 2^-10. A jump has about as much here as there.
  constexpr double far = 0x1p20, share = 0x1p-10;
  values_ += 4;
  const double middle = (piece.from + piece.to) / 2, off = least_ * far;
  const auto size_at = [&](double t) { return std::fabs(along_.value(t)); };
  const double around = std::max(size_at(middle - off), size_at(middle + off));
  return std::isfinite(around) && size_at(piece.from) <= share * around &&
         size_at(piece.to) <= share * around;
}

// Domain: a stretch in which the function is monotonic.
bool IsosurfaceSearch::cross_once(double from, double to, bool inside_from, bool inside_to,
                                  double guess, std::string_view how) {
  if (!settle(from, inside_from)) return false;
  if (inside_from == inside_to) return true;
  const Bracketed<double> in{from, to, guess, inside_from, tolerance_};
  const Bracket bracket{from, to, how};
  if (brackets_alone_) return tell({guess, inside_to, true, bracket, tolerance_});
  return tell({root_of(along_.function(), along_.line(), in), inside_to, true, bracket});
}

bool IsosurfaceSearch::settle(double t, bool inside) {
  if (told_ && inside == inside_) return true;
  return tell({t, inside, false, {}});
}
bool IsosurfaceSearch::tell(const IsosurfaceEvent& event) {
  told_ = true;
  inside_ = event.inside;
  return listener_.on_event(event);
}

// At the start of a cell: between cells nothing changes.
bool IsosurfaceSearch::inside_before(double t) { return told_ ? inside_ : inside_at(t); }
bool IsosurfaceSearch::inside_at(double t) {
  if (t == known_t_) return known_inside_;
  ++values_;
  known_t_ = t;
  return known_inside_ = along_.value(t) < 0;
}

}  // namespace tia::detail
