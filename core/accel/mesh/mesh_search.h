// The traversal of one mesh by packets of rays.
#pragma once

#include "core/accel/mesh/lone_mesh_rays.h"

namespace tia {

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
      if (active) lone_rays().alone(0, longest_axis());
    } else {
      traverse(mesh_.bvh, box_, interval, active, triangles_.limit, work_, on_leaf, few_lanes,
               [&](std::uint32_t node, Mask<Real> here) {
                 lone_rays().below(node, here, [&](int) { return longest_axis(); });
               });
    }
  }

  /// Each ray by itself; they may be longest along different axes: longest_axis(lane).
  template <class LongestAxisOf>
  void alone(Mask<Real> active, LongestAxisOf longest_axis) {
    lone_rays().below(0, active, longest_axis);
  }

 private:
  LoneMeshRays<Real, Triangles> lone_rays() {
    return {mesh_, root_, box_, ray_, triangles_, work_};
  }
  std::size_t longest_axis() const { return ray_.axes[2]; }

  [[gnu::always_inline]] void leaf(std::uint32_t first, std::uint32_t count, Mask<Real> here) {
    if constexpr (quick && lanes < Real >> 1) {
      if (tia::count(here) < static_cast<int>(2 * count))
        return lone_rays().leaf(first, count, here, longest_axis());
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
        return Real(words[(3 * axis + corner) * count]);
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

/// Traces a packet of any rays: one group for each axis along which rays are longest; or each ray
/// by itself, where they go too many ways.
template <bool quick, class Real, class Triangles>
void search(const MeshIndex& mesh, const MeshRay<Real>& ray, Triangles& triangles,
            Mask<Real> active, WorkCounter& work) {
  if (mesh.bvh.nodes.empty()) return;
  const BoxRay<Real> box(ray.origin, ray.direction, Real(0));
  const LongestAxis<Real> longest(ray.direction);
  ShearedRay<Real> sheared(ray.origin, ray.direction, longest);
  MeshSearch<Real, Triangles, quick> search(mesh, ray, box, sheared, triangles, work);
  const auto longest_of = [&](int i) { return longest.of(i); };
  if constexpr (quick && lanes < Real >> 1)
    if (scattered(box, active)) return search.alone(active, longest_of);
  const RayInterval interval(box, active);
  if constexpr (quick && lanes < Real >> 1)
    if (interval.parts_among(mesh.bvh.order.size())) return search.alone(active, longest_of);
  const Mask<Real> groups[] = {longest.x, longest.y, !longest.x && !longest.y};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Mask<Real> here = active && groups[axis];
    if (!any(here)) continue;
    sheared.turn_to(axis);
    search.through(interval, here);
  }
}

}  // namespace tia
