#include "core/radio/radio_world.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/accel/world/all_hits.h"
#include "core/boxes/box_ray.h"
#include "core/boxes/bvh_builder.h"
#include "core/radio/body_edges.h"
#include "core/radio/body_walk.h"

namespace tia {
namespace {

double largest_of(const Vec3d& p) {
  return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
}

}  // namespace

RadioWorld::RadioWorld(const Scene& scene, const Wave& wave, const Workers& workers)
    : all_(radio_bodies_of(scene, wave)) {
  std::vector<Box32> boxes;
  for (const FacetPiece& piece : all_.pieces) {
    boxes.push_back(rounded_outwards(piece.box()));
    bounds_ = around(bounds_, piece.box());
  }
  if (!boxes.empty()) bvh_ = build_bvh(boxes, workers);
  for (std::size_t i = 0; i < all_.facets.size(); ++i)
    if (all_.facets[i].endless) endless_.push_back(static_cast<std::uint32_t>(i));
  for (std::size_t i = 0; i < all_.bodies.size(); ++i)
    if (!all_.bodies[i].flat && !all_.bodies[i].is_air()) curved_.push_back(static_cast<int>(i));
  if (!curved_.empty()) {
    world_ = compile(scene, workers);
    for (const Object& object : scene.objects) {
      const Aabb box = bounds_of(object);
      if (!box.empty() && box.bounded()) bounds_ = around(bounds_, box);
    }
  }
  const double most =
      bounds_.empty() ? 1 : std::max(largest_of(bounds_.min), largest_of(bounds_.max));
  slack_ = 1e-9 * std::max(most, 1e-3);
  all_.edges = edges_of(all_, slack_);
}

bool RadioWorld::holds(int i, const Vec3d& p) const {
  const Facet& is = facet(i);
  if (is.endless) return true;
  for (std::uint32_t k = is.first_piece; k < is.first_piece + is.pieces; ++k)
    if (all_.pieces[k].holds(p, slack_)) return true;
  return false;
}

// Calls found(t, facet) for each piece and plane that from + t way meets below the limit, which
// may shrink meanwhile.
template <class Found>
void RadioWorld::meet(const Vec3d& from, const Vec3d& way, double& limit, Found found) const {
  const auto height = [&](const FlatFace& face, double& t) {
    const double slope = dot(face.normal, way);
    if (slope == 0) return false;
    t = -face.height_of(from) / slope;
    return t > 0 && t < limit;
  };
  double t = 0;
  for (const std::uint32_t i : endless_)
    if (height(all_.facets[i].face, t)) found(t, static_cast<int>(i));
  if (bvh_.nodes.empty()) return;
  WorkCounter work;
  traverse(bvh_, BoxRay<double>(from, way, 0.0), true, limit, work,
           [&](std::uint32_t first, std::uint32_t count, bool) {
             for (std::uint32_t i = first; i < first + count; ++i) {
               const FacetPiece& piece = all_.pieces[bvh_.order[i]];
               const Facet& is = all_.facets[piece.facet];
               if (height(is.face, t) && piece.holds(from + way * t, slack_))
                 found(t, static_cast<int>(piece.facet));
             }
           });
}

bool RadioWorld::blocked(const Leg& leg) const {
  const Vec3d way = leg.to - leg.from;
  const double size = length(way);
  if (size <= slack_) return false;
  bool is = false;
  const double low = slack_ / size, high = 1 - low;
  double limit = high;
  meet(leg.from, way, limit, [&](double t, int i) {
    if (i == leg.from_facet || i == leg.to_facet || t <= low || t >= high) return;
    is = true;
    limit = -1;
  });
  if (is || !world_) return is;
  std::vector<Crossed> found;
  add_curved(leg, found);
  return !found.empty();
}

std::vector<Crossed> RadioWorld::crossings(const Leg& leg) const {
  std::vector<Crossed> all;
  const Vec3d way = leg.to - leg.from;
  const double size = length(way);
  if (size <= slack_) return all;
  const double low = slack_ / size, high = 1 - low;
  double limit = high;
  meet(leg.from, way, limit, [&](double t, int i) {
    if (i == leg.from_facet || i == leg.to_facet || t <= low || t >= high) return;
    // A facet's pieces share sides, where it is met twice.
    const auto same = [&](const Crossed& each) { return each.facet == i; };
    if (std::any_of(all.begin(), all.end(), same)) return;
    const Facet& is = facet(i);
    all.push_back({t * size, i, is.body, is.element, leg.from + way * t, is.face.normal});
  });
  if (world_) add_curved(leg, all);
  std::sort(all.begin(), all.end(), [](const Crossed& a, const Crossed& b) {
    return std::tie(a.distance, a.body, a.element) < std::tie(b.distance, b.body, b.element);
  });
  return all;
}

void RadioWorld::add_curved(const Leg& leg, std::vector<Crossed>& out) const {
  const Vec3d way = leg.to - leg.from;
  const double size = length(way);
  const double start = leg.from_curved ? 1e3 * slack_ : slack_;
  const double end = size - (leg.to_curved ? 1e3 * slack_ : slack_);
  const Ray<double> ray{leg.from - world_->origin, way * (1 / size)};
  for (const Meeting& each : all_hits(*world_, ray)) {
    const int object = world_->primitive(each.primitive).object;
    if (static_cast<std::size_t>(object) >= all_.bodies.size() || body(object).flat) continue;
    if (body(object).is_air() || each.t <= start || each.t >= end) continue;
    out.push_back({each.t, -1, object, each.element, each.point + world_->origin, each.normal});
  }
}

// Farther than anything bounded.
double RadioWorld::reach_from(const Vec3d& p) const {
  return 4 * (length(bounds_.empty() ? Vec3d{} : bounds_.size()) + largest_of(p)) + 1;
}

std::optional<Crossed> RadioWorld::first(const Vec3d& from, const Vec3d& direction,
                                         int from_facet) const {
  return first(from, direction, from_facet, false);
}
std::optional<Crossed> RadioWorld::first_from_curved(const Vec3d& from,
                                                     const Vec3d& direction) const {
  return first(from, direction, -1, true);
}

std::optional<Crossed> RadioWorld::first(const Vec3d& from, const Vec3d& direction, int from_facet,
                                         bool from_curved) const {
  std::optional<Crossed> nearest;
  double limit = Aabb::far;
  meet(from, direction, limit, [&](double t, int i) {
    if (i == from_facet || t <= slack_) return;
    if (nearest && t == nearest->distance && i > nearest->facet) return;
    const Facet& is = facet(i);
    nearest = {t, i, is.body, is.element, from + direction * t, is.face.normal};
    limit = std::nextafter(t, Aabb::far);
  });
  if (!world_) return nearest;
  std::vector<Crossed> curved;
  const double reach = nearest ? nearest->distance : reach_from(from);
  add_curved({from, from + direction * reach, from_facet, -1, from_curved, false}, curved);
  if (!curved.empty()) nearest = curved.front();
  return nearest;
}

std::optional<Crossed> RadioWorld::meet_mirror(const Vec3d& from, const Vec3d& direction, int i,
                                               int number, bool from_curved) const {
  if (i >= 0) {
    const Facet& is = facet(i);
    const double t = -is.face.height_of(from) / dot(is.face.normal, direction);
    if (!(t > 0 && t < Aabb::far)) return std::nullopt;
    return Crossed{t, i, is.body, is.element, from + direction * t, is.face.normal};
  }
  std::vector<Crossed> curved;
  add_curved({from, from + direction * reach_from(from), -1, -1, from_curved, false}, curved);
  for (const Crossed& each : curved)
    if (each.body == number) return each;
  return std::nullopt;
}

int RadioWorld::body_around(const Vec3d& p) const {
  for (std::size_t i = 0; i < all_.facets.size(); ++i) {
    const Facet& is = all_.facets[i];
    const double height = is.face.height_of(p);
    if (std::fabs(height) <= slack_ && holds(static_cast<int>(i), p)) return is.body;
    if (is.endless && is.closed && height < 0) return is.body;
  }
  // An odd number of crossings on the way out. The direction's parts are in no ratio of small whole
  // numbers, as the distances of edges from points of a grid are, so that it meets no edge.
  const Vec3d way = normalize(Vec3d{0.3618033988749895, 0.7431448254773942, 0.5632455532033676});
  std::map<int, int> times;
  for (const Crossed& each : crossings({p, p + way * reach_from(p)}))
    if (each.facet < 0 || !facet(each.facet).endless) ++times[each.body];
  for (const auto& [number, count] : times)
    if (!body(number).sheet && count % 2 != 0) return number;
  return -1;
}

}  // namespace tia
