#include "core/math/first_roots.h"

#include <algorithm>
#include <array>

namespace tia {
namespace {

constexpr int most_splits = 48;
constexpr double least_share =
    0x1p-12;  // of what is left of a polynomial: a stretch that is smaller is given up as unsure

/// Which lanes' coefficients prove what, as bits.
struct Verdict {
  unsigned none = 0, one = 0, falls = 0;
  Octet guess{0.0};  // of the one root, in [0, 1]
};

unsigned without_root(std::span<const Octet> b, const Octet& noise) {
  Octet low = b[0], high = b[0];
  for (std::size_t j = 1; j < b.size(); ++j) {
    low = min_of(low, b[j]);
    high = max_of(high, b[j]);
  }
  return bits(low > noise) | bits(high < -noise);
}

// Whether the coefficients are first of one sign, then of the other. One of no certain sign may
// stand between.
void find_one(std::span<const Octet> b, const Octet& noise, Verdict& verdict) {
  const Octet sign = select(b[0] < Octet(0.0), Octet(-1.0), Octet(1.0));
  const auto above = [&](const Octet& c) { return c > noise; };
  Octet last_at(0.0), last = sign * b[0], next_at(0.0), next(0.0);
  auto good = above(last), changed = good && !good, doubted = changed;
  for (std::size_t j = 1; j < b.size(); ++j) {
    const Octet c = sign * b[j], at(static_cast<double>(j));
    const auto plus = above(c), minus = c < -noise;
    good = good && (minus || (!changed && !doubted));
    const auto turns = minus && !changed;
    next_at = select(turns, at, next_at);
    next = select(turns, c, next);
    const auto stays = plus && !changed;
    last_at = select(stays, at, last_at);
    last = select(stays, c, last);
    changed = changed || minus;
    doubted = !plus && !minus;
  }
  verdict.one = bits(good && changed);
  verdict.falls = verdict.one & bits(sign > Octet(0.0));
  const Octet way = last / (last - next);
  verdict.guess =
      (last_at + way * (next_at - last_at)) * Octet(1.0 / static_cast<double>(b.size() - 1));
}

Verdict judged(std::span<const Octet> b, const Octet& noise, unsigned wanted) {
  Verdict verdict;
  verdict.none = without_root(b, noise);
  if ((wanted & ~verdict.none) != 0) find_one(b, noise, verdict);
  return verdict;
}

// Parts b at `share` of the way: what is before goes to left, what is after to right.
void part(std::span<const Octet> b, const Octet& share, std::span<Octet> left,
          std::span<Octet> right) {
  std::copy(b.begin(), b.end(), right.begin());
  const Octet rest = Octet(1.0) - share;
  left[0] = right[0];
  for (std::size_t r = 1; r < b.size(); ++r) {
    for (std::size_t j = 0; j + r < b.size(); ++j)
      right[j] = right[j] * rest + right[j + 1] * share;
    left[r] = right[0];
  }
}

}  // namespace

FirstRoots first_roots(std::span<Octet> b, const Octet& noise, unsigned wanted) {
  constexpr std::size_t most = 65;
  std::array<Octet, most> left_part, right_part;
  const std::span<Octet> left(left_part.data(), b.size()), right(right_part.data(), b.size());
  FirstRoots found;
  Octet start(0.0), share(0.5);  // b is the polynomial on [start, 1]
  const auto take = [&](unsigned lanes, const Verdict& verdict, const Octet& end) {
    const unsigned own = lanes & verdict.one;
    if (own == 0) return;
    const auto here = mask_of(own);
    found.isolated |= own;
    found.falls |= own & verdict.falls;
    found.from = select(here, start, found.from);
    found.to = select(here, end, found.to);
    found.guess = select(here, start + verdict.guess * (end - start), found.guess);
  };
  unsigned open = wanted;
  for (int i = 0; i < most_splits; ++i) {
    const Verdict rest = judged(b, noise, open);
    take(open & ~rest.none, rest, Octet(1.0));
    open &= ~(rest.none | rest.one);
    if (open == 0) return found;
    part(b, share, left, right);
    const Octet middle = start + share * (Octet(1.0) - start);
    const Verdict near = judged(left, noise, open);
    take(open & ~near.none, near, middle);
    const unsigned on = open & near.none;
    open &= ~near.one | near.none;
    const auto goes_on = mask_of(on);
    for (std::size_t j = 0; j < b.size(); ++j) b[j] = select(goes_on, right[j], b[j]);
    start = select(goes_on, middle, start);
    share = select(goes_on, Octet(0.5), share * Octet(0.5));
    const unsigned given_up = open & bits(share < Octet(least_share));
    found.unsure |= given_up;
    open &= ~given_up;
  }
  found.unsure |= open;
  return found;
}

}  // namespace tia
