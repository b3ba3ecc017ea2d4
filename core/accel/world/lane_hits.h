// The hits of a packet with a thing that is searched in double: ray by ray, or eight rays at once.
#pragma once

#include <array>
#include <bit>

#include "core/accel/world/packet.h"
#include "core/accel/world/primitive.h"
#include "core/accel/world/solid.h"
#include "core/boxes/work_counter.h"

namespace tia {

/// LaneHits: the first hit of each lane; t is infinite where there is none.
template <class Real>
struct LaneHits {
  Real t, primitive, element;
};

namespace detail {

template <class Real>
struct HitArrays {
  std::array<LaneOf<Real>, static_cast<std::size_t>(lanes<Real>)> t, primitive{}, element{};

  HitArrays() { t.fill(infinity); }
  void set(std::size_t lane, const Boundary& hit) {
    t[lane] = static_cast<LaneOf<Real>>(hit.t);
    primitive[lane] = static_cast<LaneOf<Real>>(hit.primitive);
    element[lane] = static_cast<LaneOf<Real>>(hit.element);
  }
  LaneHits<Real> all() const {
    return {tia::load<Real>(t.data()), tia::load<Real>(primitive.data()),
            tia::load<Real>(element.data())};
  }
};

}  // namespace detail

/// The hits of the lanes of `here`, each found by crossing_of(line, t_max), which returns a
/// Boundary and need not find one beyond t_max.
template <class Real, class F>
LaneHits<Real> hits_by_lanes(const RootRay<Real>& rays, Mask<Real> here, const Real& limit,
                             F crossing_of) {
  detail::HitArrays<Real> hits;
  const Lines<Real> lines(rays);
  for (unsigned left = bits(here); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const auto at = static_cast<std::size_t>(i);
    hits.set(at, crossing_of(lines[at], static_cast<double>(lane(limit, i))));
  }
  return hits.all();
}

/// The same for eight lanes at once. Domain: a primitive that goes in eights.
template <class Real>
LaneHits<Real> hits_in_eights(const Primitive& primitive, int number, const RootRay<Real>& rays,
                              Mask<Real> here, const Real& limit, WorkCounter& work) {
  constexpr auto n = static_cast<std::size_t>(lanes<Real>);
  static_assert(n % 8 == 0);
  detail::HitArrays<Real> hits;
  const Lines<Real> lines(rays);
  std::array<double, n> t_max;
  store(widen(limit), t_max.data());
  const unsigned wanted = bits(here);
  for (std::size_t first = 0; first < n; first += 8) {
    const EightCrossings found = nearest_crossings(
        primitive, {lines.eight(first), Octet(0.0), Octet::load_unaligned(&t_max[first]),
                    wanted >> first & 0xFF});
    work.add(found.work);
    for (std::size_t i = 0; i < 8; ++i) hits.set(first + i, {found.t[i], number, found.element[i]});
  }
  return hits.all();
}

}  // namespace tia
