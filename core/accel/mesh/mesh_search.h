// The traversal of one mesh by rays.
#pragma once

#include "core/accel/mesh/mesh_index.h"

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
                 Triangles& triangles, WorkCounter& work)
      : mesh_(mesh), ray_(ray), near_(near), triangles_(triangles), work_(work) {}

  void below(std::uint32_t node, const BoxRay<float>& box) {
    traverse(
        mesh_.bvh, node, LoneRay(box), triangles_.limit,
        work_, [&](std::uint32_t first, std::uint32_t count, bool) __attribute__((always_inline)) {
          leaf(first, count);
        });
  }
  [[gnu::always_inline]] void leaf(std::uint32_t first, std::uint32_t count) {
    constexpr auto step = static_cast<std::uint32_t>(lanes<FloatRegister>);
    const float* const words = mesh_.packed.leaf(first);
    for (std::uint32_t from = 0; from < count; from += step) {
      work_.test();
      const auto hit = intersect(ray_, [&](std::size_t corner, std::size_t axis) {
        return FloatRegister::load_unaligned(words + (3 * corner + axis) * count + from);
      });
      const auto here = hit.inside && hit.t > FloatRegister(near_.least()) &&
                        hit.t <= FloatRegister(triangles_.limit);
      unsigned left = bits(here);
      if (count - from < step) left &= (1U << (count - from)) - 1;
      if (left != 0) offer(hit.t, left, &mesh_.bvh.order[first + from]);
    }
  }

 private:
  void offer(const FloatRegister& m, unsigned left, const std::uint32_t* numbers) {
    std::array<float, FloatRegister::size> each;
    m.store_unaligned(each.data());
    for (; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      const float settled = near_.settled(each[i], numbers[i]);
      triangles_.offer(settled, static_cast<float>(numbers[i]), settled > 0);
    }
  }

  const MeshIndex& mesh_;
  const ShearedRay<FloatRegister> ray_;
  const NearHits<Real> near_;
  Triangles& triangles_;
  WorkCounter& work_;
};

// ---- packets ----------------------------------------------------------------------------------

/// MeshSearch: a packet whose rays are longest along the same axis. If `quick`, the rays go on one
/// by one where only few are left.
template <class Real, class Triangles, bool quick>
class MeshSearch {
 public:
  MeshSearch(const MeshIndex& mesh, const MeshRay<Real>& root, const BoxRay<Real>& box,
             const ShearedRay<Real>& ray, Triangles& triangles, WorkCounter& work)
      : mesh_(mesh), root_(root), box_(box), ray_(ray), triangles_(triangles), work_(work) {}

  void through(const RayInterval& interval, Mask<Real> active) {
    const auto on_leaf = [&](std::uint32_t first, std::uint32_t count, Mask<Real> here)
        __attribute__((always_inline)) {
      leaf(first, count, here);
    };
    if constexpr (!quick) {
      traverse(mesh_.bvh, box_, active, triangles_.limit, work_, on_leaf);
    } else if constexpr (lanes<Real> == 1) {
      LoneMeshSearch(mesh_, ray_, NearHits(mesh_, root_, 0), triangles_, work_).below(0, box_);
    } else {
      traverse(mesh_.bvh, box_, interval, active, triangles_.limit, work_, on_leaf, few_lanes,
               [&](std::uint32_t node, Mask<Real> here) {
                 one_by_one(here, [&](int i, auto& search) { search.below(node, box_.one(i)); });
               });
    }
  }

  /// Traces each ray by itself; they may be longest along different axes.
  void alone(const LongestAxis<Real>& longest, Mask<Real> active) {
    for (unsigned left = bits(active); left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      auto own = triangles_.one(i);
      ShearedRay<float> ray = ray_.one(i);
      ray.turn_to(longest.of(i));
      LoneMeshSearch(mesh_, ray, NearHits(mesh_, root_, i), own, work_).below(0, box_.one(i));
      triangles_.set_one(i, own);
    }
  }

 private:
  // Calls work(lane, search) for each lane, with a search of its own.
  template <class Work>
  void one_by_one(Mask<Real> here, Work work) {
    for (unsigned left = bits(here); left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      auto own = triangles_.one(i);
      LoneMeshSearch search(mesh_, ray_.one(i), NearHits(mesh_, root_, i), own, work_);
      work(i, search);
      triangles_.set_one(i, own);
    }
  }
  [[gnu::always_inline]] void leaf(std::uint32_t first, std::uint32_t count, Mask<Real> here) {
    if constexpr (quick && lanes < Real >> 1) {
      if (tia::count(here) < static_cast<int>(2 * count))
        return one_by_one(here, [&](int, auto& search) { search.leaf(first, count); });
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      work_.test();
      const TriangleHit<Real> hit = meet(first, count, i);
      const std::uint32_t triangle = mesh_.bvh.order[first + i];
      const Real m = has_near_ ? settled(hit.t, triangle, here && hit.inside) : hit.t;
      triangles_.offer(m, Real(static_cast<float>(triangle)), here && hit.inside && m > Real(0));
    }
  }
  // Settles the lanes with hits near their origins, one by one. In double nothing has to be
  // settled.
  [[gnu::noinline]] Real settled(const Real& m, std::uint32_t triangle, Mask<Real> here) const {
    if constexpr (std::is_same_v<Real, double>) {
      return m;
    } else {
      const unsigned near =
          bits(here && m < root_.near && m > root_.near * Real(-tolerance::mesh_behind));
      if (near == 0) return m;
      std::array<float, static_cast<std::size_t>(lanes<Real>)> each;
      store(m, each.data());
      for (unsigned left = near; left != 0; left &= left - 1) {
        const int i = std::countr_zero(left);
        float& own = each[static_cast<std::size_t>(i)];
        own = NearHits(mesh_, root_, i).settled(own, triangle);
      }
      return load<Real>(each.data());
    }
  }
  TriangleHit<Real> meet(std::uint32_t first, std::uint32_t count, std::uint32_t i) const {
    if constexpr (std::is_same_v<Real, double>) {
      const std::size_t triangle = mesh_.bvh.order[first + i];
      return intersect(ray_, [&](std::size_t corner, std::size_t axis) {
        const Vec3d p = mesh_.measured(mesh_.corner(triangle, corner));
        return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
      });
    } else {
      const float* const words = mesh_.packed.leaf(first) + i;
      return intersect(ray_, [&](std::size_t corner, std::size_t axis) {
        return Real(words[(3 * corner + axis) * count]);
      });
    }
  }

  const MeshIndex& mesh_;
  const MeshRay<Real>& root_;
  const bool has_near_ = any(root_.near > Real(0));
  const BoxRay<Real>& box_;
  const ShearedRay<Real>& ray_;
  Triangles& triangles_;
  WorkCounter& work_;
};

/// Traces a packet of any rays: one group for each axis along which rays are longest.
template <bool quick, class Real, class Triangles>
void search(const MeshIndex& mesh, const MeshRay<Real>& ray, Triangles& triangles,
            Mask<Real> active, WorkCounter& work) {
  if (mesh.bvh.nodes.empty()) return;
  const BoxRay<Real> box(ray.origin, ray.direction, Real(0));
  const LongestAxis<Real> longest(ray.direction);
  ShearedRay<Real> sheared(ray.origin, ray.direction, longest);
  MeshSearch<Real, Triangles, quick> search(mesh, ray, box, sheared, triangles, work);
  const RayInterval interval(box, active);
  if constexpr (quick && lanes < Real >> 1) {
    if (interval.scattered()) return search.alone(longest, active);
  }
  const Mask<Real> groups[] = {longest.x, longest.y, !longest.x && !longest.y};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Mask<Real> here = active && groups[axis];
    if (!any(here)) continue;
    sheared.turn_to(axis);
    search.through(interval, here);
  }
}

}  // namespace tia
