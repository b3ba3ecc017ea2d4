#include "core/scene/triangulation.h"

#include <algorithm>
#include <cmath>

namespace tia {
namespace {

// Twice the area of a b c, > 0 where they turn from x towards y.
double turn_of(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
double distance_of(const PlanPoint& a, const PlanPoint& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}
bool same_place(const PlanPoint& a, const PlanPoint& b) { return a.x == b.x && a.y == b.y; }

/// EarClipper: one ring of numbered points, holes joined to it, that loses its ears.
class EarClipper {
 public:
  explicit EarClipper(const std::vector<Ring>& rings) {
    for (const Ring& ring : rings) points_.insert(points_.end(), ring.begin(), ring.end());
    sign_ = doubled_area(rings.front()) < 0 ? -1 : 1;
    std::vector<std::vector<std::uint32_t>> holes;
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < rings.size(); ++i) {
      std::vector<std::uint32_t> ring(rings[i].size());
      for (std::uint32_t& each : ring) each = number++;
      const bool same_way = (doubled_area(rings[i]) < 0) == (sign_ < 0);
      if (i > 0 && same_way) std::reverse(ring.begin(), ring.end());
      if (i == 0) ring_ = ring;
      else holes.push_back(std::move(ring));
    }
    // From the right: the bridge of one does not cross another.
    std::sort(holes.begin(), holes.end(), [&](const auto& a, const auto& b) {
      return points_[rightmost(a)].x > points_[rightmost(b)].x;
    });
    for (const auto& hole : holes) join(hole);
  }

  std::vector<std::uint32_t> operator()() {
    std::vector<std::uint32_t> corners;
    while (ring_.size() > 3) {
      const std::size_t ear = find_ear();
      add_corner(ear, corners);
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    if (ring_.size() == 3) add_corner(1, corners);
    return corners;
  }

 private:
  const PlanPoint& at(std::size_t i) const { return points_[ring_[i % ring_.size()]]; }
  std::size_t before(std::size_t i) const { return (i + ring_.size() - 1) % ring_.size(); }

  std::uint32_t rightmost(const std::vector<std::uint32_t>& ring) const {
    return *std::max_element(ring.begin(), ring.end(), [&](std::uint32_t a, std::uint32_t b) {
      return points_[a].x < points_[b].x;
    });
  }

  // Whether a straight line between two points crosses no side of the ring or of the hole.
  bool sees(const PlanPoint& a, const PlanPoint& b, const std::vector<std::uint32_t>& ring) const {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PlanPoint &p = points_[ring[i]], &q = points_[ring[(i + 1) % ring.size()]];
      if (same_place(p, a) || same_place(p, b) || same_place(q, a) || same_place(q, b)) continue;
      if ((turn_of(a, b, p) > 0) != (turn_of(a, b, q) > 0) &&
          (turn_of(p, q, a) > 0) != (turn_of(p, q, b) > 0))
        return false;
    }
    return true;
  }
  // Whether a line from corner i goes into the ring.
  bool goes_inside(std::size_t i, const PlanPoint& to) const {
    const PlanPoint &p = at(before(i)), &q = at(i), &r = at(i + 1);
    const bool left_of_last = sign_ * turn_of(p, q, to) > 0,
               left_of_next = sign_ * turn_of(q, r, to) > 0;
    return sign_ * turn_of(p, q, r) > 0 ? left_of_last && left_of_next
                                        : left_of_last || left_of_next;
  }

  // To the nearest corner that the hole's rightmost point sees.
  void join(const std::vector<std::uint32_t>& hole) {
    const std::uint32_t from = rightmost(hole);
    const PlanPoint& p = points_[from];
    std::size_t best = ring_.size();
    double nearest = 0;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const double far = distance_of(at(i), p);
      if (best < ring_.size() && far >= nearest) continue;
      if (!goes_inside(i, p) || !sees(p, at(i), ring_) || !sees(p, at(i), hole)) continue;
      best = i, nearest = far;
    }
    if (best == ring_.size()) best = 0;
    std::vector<std::uint32_t> bridge;
    const auto first = std::find(hole.begin(), hole.end(), from);
    bridge.insert(bridge.end(), first, hole.end());
    bridge.insert(bridge.end(), hole.begin(), first);
    bridge.push_back(from);
    bridge.push_back(ring_[best]);
    ring_.insert(ring_.begin() + static_cast<std::ptrdiff_t>(best) + 1, bridge.begin(),
                 bridge.end());
  }

  bool is_ear(std::size_t i) const {
    const PlanPoint &a = at(before(i)), &b = at(i), &c = at(i + 1);
    if (!(sign_ * turn_of(a, b, c) > 0)) return false;
    for (const std::uint32_t number : ring_) {
      const PlanPoint& p = points_[number];
      if (same_place(p, a) || same_place(p, b) || same_place(p, c)) continue;
      if (sign_ * turn_of(a, b, p) >= 0 && sign_ * turn_of(b, c, p) >= 0 &&
          sign_ * turn_of(c, a, p) >= 0)
        return false;
    }
    return true;
  }
  // Where rings cross or touch there may be none: then what is straight or flattest goes.
  std::size_t find_ear() const {
    std::size_t flattest = 0;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      if (is_ear(i)) return i;
      const auto bend = [&](std::size_t k) {
        return std::fabs(turn_of(at(before(k)), at(k), at(k + 1)));
      };
      if (bend(i) < bend(flattest)) flattest = i;
    }
    return flattest;
  }
  void add_corner(std::size_t i, std::vector<std::uint32_t>& corners) const {
    corners.insert(corners.end(), {ring_[before(i)], ring_[i], ring_[(i + 1) % ring_.size()]});
  }

  std::vector<PlanPoint> points_;
  std::vector<std::uint32_t> ring_;
  double sign_ = 1;
};

}  // namespace

double doubled_area(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanPoint &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

std::vector<std::uint32_t> triangles_of(const std::vector<Ring>& rings) {
  return EarClipper(rings)();
}

}  // namespace tia
