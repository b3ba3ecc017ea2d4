#include "core/models/smooth.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "core/math/deterministic.h"
#include "core/math/vec3.h"

namespace tia {
namespace {

constexpr double per_degree = 0.017453292519943295;
constexpr std::size_t most_faces = 8;  // at one edge

/// Smoothing: a mesh's corners, three a triangle, linked where they share a normal.
class Smoothing {
 public:
  Smoothing(std::span<const double> positions, std::span<const std::uint32_t> indices,
            double degrees)
      : positions_(positions),
        indices_(indices),
        least_cosine_(cos_of(degrees * per_degree)),
        linked_(indices.size()) {
    std::iota(linked_.begin(), linked_.end(), 0U);
  }

  SmoothVertices vertices() {
    for (std::uint32_t i = 0; i < indices_.size(); i += 3) faces_.push_back(unit_of(turn(i)));
    link_edges();
    if (!bends_) return {};
    sum_up();
    return parted();
  }

 private:
  struct Edge {
    std::uint32_t from, to;    // places, the lower first
    std::uint32_t start, end;  // the corners there
  };

  Vec3d position(std::uint32_t vertex) const {
    const double* at = &positions_[3 * std::size_t{vertex}];
    return {at[0], at[1], at[2]};
  }
  Vec3d corner(std::uint32_t i) const { return position(indices_[i]); }
  static std::uint32_t next(std::uint32_t i) { return i % 3 == 2 ? i - 2 : i + 1; }

  // The cross product of both edges at a corner, over the squares of their lengths; 0 without area.
  Vec3d turn(std::uint32_t i) const {
    const Vec3d a = corner(next(i)) - corner(i), b = corner(next(next(i))) - corner(i);
    const Vec3d turned = cross(a, b) * (1 / (dot(a, a) * dot(b, b)));
    const double square = dot(turned, turned);
    return square > 0 && square < 1e300 ? turned : Vec3d{};
  }
  static Vec3d unit_of(const Vec3d& v) {
    const double square = dot(v, v);
    return square > 0 ? v * (1 / std::sqrt(square)) : Vec3d{};
  }

  // ---- what is linked ---------------------------------------------------------------------------

  // Of each vertex the first that lies where it does.
  std::vector<std::uint32_t> places() const {
    std::vector<std::uint32_t> order(positions_.size() / 3), place(order.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto at = [&](std::uint32_t i) {
      const Vec3d p = position(i);
      return std::tuple(p.x, p.y, p.z);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return at(a) < at(b); });
    for (std::size_t i = 0; i < order.size(); ++i) {
      const bool same = i > 0 && at(order[i - 1]) == at(order[i]);
      place[order[i]] = same ? place[order[i - 1]] : order[i];
    }
    return place;
  }
  std::vector<Edge> edges() const {
    const std::vector<std::uint32_t> place = places();
    std::vector<Edge> all;
    all.reserve(indices_.size());
    for (std::uint32_t i = 0; i < indices_.size(); ++i) {
      const std::uint32_t a = place[indices_[i]], b = place[indices_[next(i)]];
      if (a < b) all.push_back({a, b, i, next(i)});
      else all.push_back({b, a, next(i), i});
    }
    const auto key = [](const Edge& e) { return std::tie(e.from, e.to, e.start, e.end); };
    std::sort(all.begin(), all.end(),
              [&](const Edge& a, const Edge& b) { return key(a) < key(b); });
    return all;
  }
  void link_edges() {
    const std::vector<Edge> all = edges();
    for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
      while (end < all.size() && all[end].from == all[first].from && all[end].to == all[first].to)
        ++end;
      if (end - first > most_faces) continue;
      for (std::size_t i = first; i < end; ++i)
        for (std::size_t k = i + 1; k < end; ++k) link(all[i], all[k]);
    }
  }
  void link(const Edge& a, const Edge& b) {
    const Vec3d &n = faces_[a.start / 3], &other = faces_[b.start / 3];
    if (dot(n, n) == 0 || dot(other, other) == 0 || !(dot(n, other) > least_cosine_)) return;
    constexpr double flat = 1e-6;  // the sine of what counts as one plane
    const Vec3d bend = cross(n, other);
    bends_ = bends_ || dot(bend, bend) > flat * flat;
    unite(a.start, b.start);
    unite(a.end, b.end);
  }
  std::uint32_t group(std::uint32_t i) {
    while (linked_[i] != i) i = linked_[i] = linked_[linked_[i]];
    return i;
  }
  // The lowest corner stands for all.
  void unite(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t i = group(a), k = group(b);
    linked_[std::max(i, k)] = std::min(i, k);
  }

  // ---- what they share --------------------------------------------------------------------------

  void sum_up() {
    sums_.resize(indices_.size());
    for (std::uint32_t i = 0; i < indices_.size(); ++i) sums_[group(i)] = sums_[group(i)] + turn(i);
  }
  // Where all comes to nothing, the first face's; where that has no area, no ray meets it.
  Vec3d normal_of(std::uint32_t first) const {
    for (const Vec3d& n : {unit_of(sums_[first]), faces_[first / 3]})
      if (dot(n, n) > 0) return n;
    return {0, 0, 1};
  }
  SmoothVertices parted() {
    SmoothVertices out;
    std::unordered_map<std::uint64_t, std::uint32_t> known;
    for (std::uint32_t i = 0; i < indices_.size(); ++i) {
      const std::uint32_t first = group(i);
      const std::uint64_t key = std::uint64_t{indices_[i]} << 32U | first;
      const auto [at, is_new] = known.try_emplace(key, static_cast<std::uint32_t>(out.from.size()));
      out.indices.push_back(at->second);
      if (!is_new) continue;
      const Vec3d n = normal_of(first);
      out.from.push_back(indices_[i]);
      out.normals.insert(out.normals.end(), {n.x, n.y, n.z});
    }
    return out;
  }

  std::span<const double> positions_;
  std::span<const std::uint32_t> indices_;
  const double least_cosine_;
  std::vector<std::uint32_t> linked_;  // of each corner one of its group, itself in the end
  std::vector<Vec3d> faces_;           // unit normals; 0 without area
  std::vector<Vec3d> sums_;            // of each group, at its first corner
  bool bends_ = false;                 // whether faces of two planes share a normal
};

}  // namespace

SmoothVertices smooth(std::span<const double> positions, std::span<const std::uint32_t> indices,
                      double degrees) {
  return Smoothing(positions, indices, degrees).vertices();
}

}  // namespace tia
