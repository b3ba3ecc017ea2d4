// Single rays through one mesh, and what is looked for there.
#pragma once

#include <bit>
#include <utility>

#include "core/accel/mesh/mesh_index.h"
#include "core/boxes/lone_traversal.h"

namespace tia {

// ---- queries, in units of the mesh -------------------------------------------------------------

/// NearestTriangle: the closest triangle up to the limit; at equal distances the first of the mesh.
template <class Real>
struct NearestTriangle {
  Real limit;
  Real number = Real(infinity);

  Mask<Real> found() const { return number < Real(infinity); }
  void offer(const Real& m, const Real& triangle, Mask<Real> here) {
    const Mask<Real> nearer = here && (m < limit || (m == limit && triangle < number));
    limit = select(nearer, m, limit);
    number = select(nearer, triangle, number);
  }
  NearestTriangle<float> one(int i) const { return {lane(limit, i), lane(number, i)}; }
  void set_one(int i, const NearestTriangle<float>& ray) {
    set_lane(limit, i, ray.limit);
    set_lane(number, i, ray.number);
  }
};

/// AnyTriangle: whether there is a triangle before the limit. Domain: limits above 0.
template <class Real>
struct AnyTriangle {
  Real limit;  ///< below 0 once there is one, so that nothing further is tried

  Mask<Real> found() const { return limit < Real(0); }
  void offer(const Real& m, const Real&, Mask<Real> here) {
    limit = select(here && m < limit, Real(-1), limit);
  }
  AnyTriangle<float> one(int i) const { return {lane(limit, i)}; }
  void set_one(int i, const AnyTriangle<float>& ray) { set_lane(limit, i, ray.limit); }
};

// ---- hits near the origin ----------------------------------------------------------------------

/// NearHits: decides in double, by the triangle's plane, whether a hit that float finds close to a
/// ray's origin is in front of it (tolerance::mesh_near).
template <class Real>
class NearHits {
 public:
  NearHits(const MeshIndex& mesh, const MeshRay<Real>& ray, int i)
      : mesh_(mesh), ray_(ray), i_(i), near_(static_cast<float>(lane(ray.near, i))) {}

  /// The least distance in float of a hit that may be in front of the origin.
  float least() const { return near_ * -tolerance::mesh_behind; }
  /// Returns: m, at least 2^-30, if the hit is in front of the origin; else a number below 0.
  float settled(float m, std::size_t triangle) const {
    if (m >= near_) return m;
    const double exact = mesh_.plane_distance(triangle, ray_.exact(i_));
    return exact > 0 && exact < tolerance::mesh_near_plane ? std::max(m, 0x1p-30F) : -1;
  }

 private:
  const MeshIndex& mesh_;
  const MeshRay<Real>& ray_;
  int i_;
  float near_;
};

// ---- one ray ----------------------------------------------------------------------------------

/// LoneMeshSearch: a single ray, tried on as many triangles at once as a register has lanes.
template <class Triangles, class Real>
class LoneMeshSearch {
 public:
  LoneMeshSearch(const MeshIndex& mesh, const ShearedRay<float>& ray, const NearHits<Real>& near,
                 const Triangles& triangles)
      : mesh_(mesh), ray_(ray), near_(near), triangles_(triangles) {}

  const Triangles& triangles() const { return triangles_; }
  /// Through which of a leaf's triangles the ray may pass, as bits.
  [[gnu::always_inline]] unsigned test(std::uint32_t first, std::uint32_t count) const {
    unsigned met = 0;
    for_each_register(
        count, [&](std::uint32_t from) __attribute__((always_inline)) {
          const ShearedRay<FloatRegister> ray(ray_);
          met |= bits(SeenTriangle(ray, corners(first, count, from)).inside()) << from;
        });
    return met & ((1U << count) - 1);
  }
  /// Takes those that it hits, of those.
  void take(std::uint32_t first, std::uint32_t count, unsigned met) {
    for_each_register(count, [&](std::uint32_t from) { take(first, count, from, met >> from); });
  }

 private:
  static constexpr auto step = static_cast<std::uint32_t>(lanes<FloatRegister>);

  template <class F>
  [[gnu::always_inline]] static void for_each_register(std::uint32_t count, F f) {
    const std::uint32_t end = step < Bvh::largest_leaf ? count : 1;  // of registers that are begun
    for (std::uint32_t from = 0; from < end; from += step) f(from);
  }
  [[gnu::always_inline]] auto corners(std::uint32_t first, std::uint32_t count,
                                      std::uint32_t from) const {
    return [ words = mesh_.packed.leaf(first) + from, n = std::size_t{count} ](
        std::size_t corner, std::size_t axis) __attribute__((always_inline)) {
      const float* const row = words + 3 * n * axis;
      return FloatRegister::load_unaligned(row + n * corner);
    };
  }
  // As intersect (triangle.h), which would ask again what the test has told: 1 to 2 % of a ray.
  void take(std::uint32_t first, std::uint32_t count, std::uint32_t from, unsigned met) {
    const auto corner = corners(first, count, from);
    const ShearedRay<FloatRegister> ray(ray_);
    const SeenTriangle<FloatRegister> triangle(ray, corner);
    TriangleHit<FloatRegister> hit{triangle.inside(), triangle.t(ray)};
    const auto doubtful = triangle.doubtful();
    if ((bits(doubtful) & met) != 0) {
      hit = settled(ray, corner, hit.inside && doubtful, hit);
      met &= bits(hit.inside);
    }
    const auto here =
        hit.t > FloatRegister(near_.least()) && hit.t <= FloatRegister(triangles_.limit);
    const float* const numbers = mesh_.packed.leaf(first) + std::size_t{9} * count + from;
    for (unsigned left = bits(here) & met; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      const auto number = std::bit_cast<std::uint32_t>(numbers[i]);
      __builtin_prefetch(&mesh_.planes[number]);  // where most nearest hits will be settled
      const float m = near_.settled(lane(hit.t, static_cast<int>(i)), number);
      triangles_.offer(m, static_cast<float>(number), m > 0);
    }
  }

  const MeshIndex& mesh_;
  const ShearedRay<float> ray_;
  const NearHits<Real> near_;
  Triangles triangles_;
};

/// LoneMeshRays: the rays of a packet through a mesh, each by itself.
template <class Real, class Triangles>
class LoneMeshRays {
 public:
  LoneMeshRays(const MeshIndex& mesh, const MeshRay<Real>& root, const BoxRay<Real>& box,
               const ShearedRay<Real>& ray, Triangles& triangles, WorkCounter& work)
      : mesh_(mesh), root_(root), box_(box), ray_(ray), triangles_(triangles), work_(work) {}

  /// Through the subtree of a node, by turns. longest_axis(lane): along which a ray is longest.
  /// Apart: its 60 KiB of the stack are not to be held by what calls itself, for groups in groups.
  template <class LongestAxisOf>
  [[gnu::noinline]] void below(std::uint32_t node, Mask<Real> active, LongestAxisOf longest_axis) {
    LoneTraversals<true> rays;
    Searches searches;
    for_each_lane(active, [&](int i) {
      rays.add(box_, i, lane(triangles_.limit, i), node, rays.all().size());
      add(i, longest_axis(i), searches);
    });
    traverse(mesh_.bvh, rays.all(), work_, Leaves{searches.all()});
    std::size_t number = 0;
    for_each_lane(active,
                  [&](int i) { triangles_.set_one(i, searches.all()[number++].triangles()); });
  }
  /// One of them through all of the mesh.
  void alone(int i, std::size_t longest_axis) {
    Searches one;
    Search& search = add(i, longest_axis, one);
    traverse(mesh_.bvh, 0, LoneRay<true>(box_, i), search.triangles().limit, work_,
             [&](std::uint32_t first, std::uint32_t count, bool) {
               work_.test();
               const unsigned met = search.test(first, count);
               if (met != 0) search.take(first, count, met);
             });
    triangles_.set_one(i, search.triangles());
  }
  /// All longest along the same axis, on a leaf.
  [[gnu::always_inline]] void leaf(std::uint32_t first, std::uint32_t count, Mask<Real> here,
                                   std::size_t longest_axis) {
    for_each_lane(
        here, [&](int i) __attribute__((always_inline)) {
          Searches one;
          Search& search = add(i, longest_axis, one);
          work_.test();
          const unsigned met = search.test(first, count);
          if (met == 0) return;
          search.take(first, count, met);
          triangles_.set_one(i, search.triangles());
        });
  }

 private:
  using Search = LoneMeshSearch<decltype(std::declval<Triangles>().one(0)), Real>;
  using Searches = FixedList<Search, most_lone_rays>;
  // As traverse calls them.
  struct Leaves {
    std::span<Search> searches;

    [[gnu::always_inline]] unsigned test(const LoneTraversal<true>& ray, std::uint32_t first,
                                         std::uint32_t count) const {
      return searches[ray.number].test(first, count);
    }
    float take(const LoneTraversal<true>& ray, std::uint32_t first, std::uint32_t count,
               unsigned met) const {
      Search& own = searches[ray.number];
      own.take(first, count, met);
      return own.triangles().limit;
    }
  };

  Search& add(int i, std::size_t longest_axis, Searches& to) const {
    ShearedRay<float> ray = ray_.one(i);
    ray.turn_to(longest_axis);
    return to.add(mesh_, ray, NearHits(mesh_, root_, i), triangles_.one(i));
  }

  const MeshIndex& mesh_;
  const MeshRay<Real>& root_;
  const BoxRay<Real>& box_;
  const ShearedRay<Real>& ray_;
  Triangles& triangles_;
  WorkCounter& work_;
};

}  // namespace tia
