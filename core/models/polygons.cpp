#include "core/models/polygons.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/math/vec3.h"

namespace tia {
namespace {

using PolygonCorners = std::span<const std::uint32_t>;
using PolygonTriangles = std::vector<std::uint32_t>;

/// PolygonPoint: a corner as it is seen along the normal.
struct PolygonPoint {
  double x, y;
  bool operator==(const PolygonPoint&) const = default;
};

// Twice the area of the triangle, positive where it turns counter-clockwise.
double polygon_turn(const PolygonPoint& a, const PolygonPoint& b, const PolygonPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// PolygonPlane: shows corners in the coordinate plane that the normal is nearest to, moved there
/// along the normal, so that the whole polygon turns counter-clockwise. Areas are true but for a
/// common factor, and what lies in a coordinate plane is shown without rounding.
class PolygonPlane {
 public:
  PolygonPlane(PolygonCorners corners, std::span<const double> positions)
      : corners_(corners), positions_(positions), origin_(position(0)) {
    const Vec3d n = newell(), size{std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)};
    if (size.z >= size.x && size.z >= size.y) {
      const double across = n.z == 0 ? 1 : n.z;
      show({1, 0, -n.x / across}, {0, 1, -n.y / across}, n.z);
    } else if (size.y >= size.x) {
      show({0, -n.z / n.y, 1}, {1, -n.x / n.y, 0}, n.y);
    } else {
      show({-n.y / n.x, 1, 0}, {-n.z / n.x, 0, 1}, n.x);
    }
  }
  PolygonPoint operator[](std::size_t corner) const {
    const Vec3d p = relative(corner);
    return {dot(x_, p), dot(y_, p)};
  }

 private:
  void show(const Vec3d& x, const Vec3d& y, double normal) {
    x_ = normal < 0 ? y : x;
    y_ = normal < 0 ? x : y;
  }
  Vec3d position(std::size_t corner) const {
    const double* p = &positions_[std::size_t{3} * corners_[corner]];
    return {p[0], p[1], p[2]};
  }
  // From the first corner: far from the origin areas would drown in rounding.
  Vec3d relative(std::size_t corner) const { return position(corner) - origin_; }
  Vec3d newell() const {
    Vec3d normal{}, a{};
    for (std::size_t i = 1; i < corners_.size(); ++i) {
      const Vec3d b = relative(i);
      normal = normal + cross(a, b);
      a = b;
    }
    return normal;
  }

  PolygonCorners corners_;
  std::span<const double> positions_;
  Vec3d origin_, x_{}, y_{};
};

// Whether the first corner left is an ear until the end, as in what is convex: then no lists are
// needed. With all corners but the last convex, nothing can lie in the way.
bool is_polygon_fan(const PolygonPlane& plane, std::size_t corners) {
  const PolygonPoint hub = plane[corners - 1];
  PolygonPoint before = hub, at = plane[0];
  for (std::size_t i = 0; i + 2 < corners; ++i) {
    const PolygonPoint after = plane[i + 1];
    if (polygon_turn(before, at, after) <= 0 || polygon_turn(hub, at, after) <= 0) return false;
    before = at;
    at = after;
  }
  return polygon_turn(before, at, hub) > 0;
}

void add_polygon_fan(PolygonCorners corners, PolygonTriangles& triangles) {
  for (std::size_t i = 0; i + 2 < corners.size(); ++i)
    triangles.insert(triangles.end(), {corners.back(), corners[i], corners[i + 1]});
}

/// EarCutter: the corners that are left, in a ring, and what is known of each.
class EarCutter {
 public:
  EarCutter(PolygonCorners corners, const PolygonPlane& plane)
      : corners_(corners), ring_(corners.size()), ears_((corners.size() + 63) / 64) {
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) ring_[i] = {plane[i], (i + n - 1) % n, (i + 1) % n, none};
    for (std::size_t i = 0; i < n; ++i) see_whether_convex(i);
    for (std::size_t i = 0; i < n; ++i) see_whether_ear(i);
  }
  void cut(PolygonTriangles& triangles) {
    for (std::size_t left = corners_.size(); left > 3; --left) cut(first_ear(), triangles);
    add(first_, triangles);
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  struct Link {
    PolygonPoint point;
    std::size_t before, after;
    std::size_t dent;  ///< its number among the dents, or none
  };
  struct Dent {
    PolygonPoint point;
    std::size_t corner;
  };

  void add(std::size_t corner, PolygonTriangles& triangles) const {
    const Link& link = ring_[corner];
    triangles.insert(triangles.end(),
                     {corners_[link.before], corners_[corner], corners_[link.after]});
  }
  void cut(std::size_t corner, PolygonTriangles& triangles) {
    add(corner, triangles);
    const std::size_t before = ring_[corner].before, after = ring_[corner].after;
    ring_[before].after = after;
    ring_[after].before = before;
    if (corner == first_) first_ = after;
    set_ear(corner, false);
    fill(corner);
    for (const std::size_t each : {before, after}) see_whether_convex(each);
    for (const std::size_t each : {before, after}) see_whether_ear(each);
  }
  std::size_t first_ear() const {
    for (std::size_t word = first_ / 64; word < ears_.size(); ++word)
      if (ears_[word] != 0)
        return word * 64 + static_cast<std::size_t>(std::countr_zero(ears_[word]));
    return first_;
  }
  void set_ear(std::size_t corner, bool is) {
    const std::uint64_t bit = std::uint64_t{1} << corner % 64;
    ears_[corner / 64] = is ? ears_[corner / 64] | bit : ears_[corner / 64] & ~bit;
  }

  // ---- dents: corners that are not convex, in any order ---------------------------------------

  double turn_at(const Link& link) const {
    return polygon_turn(ring_[link.before].point, link.point, ring_[link.after].point);
  }
  void see_whether_convex(std::size_t corner) {
    Link& link = ring_[corner];
    if (turn_at(link) > 0) return fill(corner);
    if (link.dent != none) return;
    link.dent = dents_.size();
    dents_.push_back({link.point, corner});
  }
  void fill(std::size_t corner) {
    const std::size_t at = std::exchange(ring_[corner].dent, none);
    if (at == none) return;
    dents_[at] = dents_.back();
    dents_.pop_back();
    if (at < dents_.size()) ring_[dents_[at].corner].dent = at;
  }

  // ---- ears -----------------------------------------------------------------------------------

  void see_whether_ear(std::size_t corner) {
    set_ear(corner, ring_[corner].dent == none && !is_in_the_way_of(corner));
  }
  bool is_in_the_way_of(std::size_t corner) const {
    const Link& link = ring_[corner];
    const PolygonPoint &a = ring_[link.before].point, &b = link.point, &c = ring_[link.after].point;
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [low, high] = std::minmax({a.y, b.y, c.y});
    for (const Dent& dent : dents_) {
      const PolygonPoint& p = dent.point;
      if (p.x < left || p.x > right || p.y < low || p.y > high) continue;
      if (polygon_turn(a, b, p) < 0 || polygon_turn(b, c, p) < 0 || polygon_turn(c, a, p) < 0)
        continue;
      if (p == a || p == c) continue;  // one beside it, or one that only touches it
      if (p != b || goes_into(dent, a, b, c)) return true;
    }
    return false;
  }
  // Whether the outline, at b's place a second time, goes on between b's own sides.
  bool goes_into(const Dent& dent, const PolygonPoint& a, const PolygonPoint& b,
                 const PolygonPoint& c) const {
    const auto between = [&](const PolygonPoint& p) {
      return polygon_turn(a, b, p) > 0 && polygon_turn(b, c, p) > 0;
    };
    const Link& link = ring_[dent.corner];
    return between(ring_[link.before].point) || between(ring_[link.after].point);
  }

  PolygonCorners corners_;
  std::vector<Link> ring_;
  std::vector<std::uint64_t> ears_;  // a bit a corner
  std::vector<Dent> dents_;
  std::size_t first_ = 0;
};

}  // namespace

void triangulate(PolygonCorners corners, std::span<const double> positions,
                 PolygonTriangles& triangles) {
  if (corners.size() < 3) return;
  if (corners.size() == 3) {
    triangles.insert(triangles.end(), corners.begin(), corners.end());
    return;
  }
  const PolygonPlane plane(corners, positions);
  if (is_polygon_fan(plane, corners.size())) add_polygon_fan(corners, triangles);
  else EarCutter(corners, plane).cut(triangles);
}

}  // namespace tia
