// The search of rays through one mesh.
#pragma once

#include "core/accel/mesh_index.h"

namespace tia {

// ---- queries, in the mesh's own measure -------------------------------------------------------

/// The nearest triangle not farther than the limit; at equal distances the first of the mesh.
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

/// Whether there is a triangle before the limit. Domain: limits above 0.
template <class Real>
struct AnyTriangle {
  Real limit;  ///< below 0 where there is one: then nothing is left to look for

  Mask<Real> found() const { return limit < Real(0); }
  void offer(const Real& m, const Real&, Mask<Real> here) {
    limit = select(here && m < limit, Real(-1), limit);
  }
  AnyTriangle<float> one(int i) const { return {lane(limit, i)}; }
  void set_one(int i, const AnyTriangle<float>& ray) { set_lane(limit, i, ray.limit); }
};

// ---- one ray ----------------------------------------------------------------------------------

/// A ray by itself, on as many triangles at once as a register has lanes.
template <class Triangles>
class LoneMeshSearch {
 public:
  LoneMeshSearch(const MeshIndex& mesh, const ShearedRay<float>& ray, Triangles& triangles,
                 Effort& effort)
      : mesh_(mesh), ray_(ray), triangles_(triangles), effort_(effort) {}

  void below(std::uint32_t node, const BoxRay<float>& box) {
    traverse(
        mesh_.bvh, node, LoneRay(box), triangles_.limit, effort_,
        [&](std::uint32_t first, std::uint32_t count, bool)
            __attribute__((always_inline)) { leaf(first, count); });
  }
  [[gnu::always_inline]] void leaf(std::uint32_t first, std::uint32_t count) {
    constexpr auto step = static_cast<std::uint32_t>(lanes<FloatRegister>);
    const float* const words = mesh_.packed.leaf(first);
    for (std::uint32_t from = 0; from < count; from += step) {
      effort_.test();
      const auto hit = intersect(ray_, [&](std::size_t corner, std::size_t axis) {
        return FloatRegister::load_unaligned(words + (3 * corner + axis) * count + from);
      });
      const auto here =
          hit.inside && hit.t > FloatRegister(0) && hit.t <= FloatRegister(triangles_.limit);
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
      triangles_.offer(each[i], static_cast<float>(numbers[i]), true);
    }
  }

  const MeshIndex& mesh_;
  const ShearedRay<FloatRegister> ray_;
  Triangles& triangles_;
  Effort& effort_;
};

// ---- packets ----------------------------------------------------------------------------------

/// A packet whose rays are longest along the same axis. Where `quick`, few rays go alone.
template <class Real, class Triangles, bool quick>
class MeshSearch {
 public:
  MeshSearch(const MeshIndex& mesh, const BoxRay<Real>& box, const ShearedRay<Real>& ray,
             Triangles& triangles, Effort& effort)
      : mesh_(mesh), box_(box), ray_(ray), triangles_(triangles), effort_(effort) {}

  void through(const Bundle& bundle, Mask<Real> active) {
    const auto on_leaf = [&](std::uint32_t first, std::uint32_t count, Mask<Real> here) {
      leaf(first, count, here);
    };
    if constexpr (!quick) {
      traverse(mesh_.bvh, box_, active, triangles_.limit, effort_, on_leaf);
    } else if constexpr (lanes<Real> == 1) {
      LoneMeshSearch(mesh_, ray_, triangles_, effort_).below(0, box_);
    } else {
      traverse(mesh_.bvh, box_, bundle, active, triangles_.limit, effort_, on_leaf, few,
               [&](std::uint32_t node, Mask<Real> here) {
                 one_by_one(here, [&](int i, auto& search) { search.below(node, box_.one(i)); });
               });
    }
  }

  /// Each ray by itself, along whichever axis.
  void alone(const LongestAxis<Real>& longest, Mask<Real> active) {
    for (unsigned left = bits(active); left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      auto own = triangles_.one(i);
      ShearedRay<float> ray = ray_.one(i);
      ray.turn_to(longest.of(i));
      LoneMeshSearch(mesh_, ray, own, effort_).below(0, box_.one(i));
      triangles_.set_one(i, own);
    }
  }

 private:
  static constexpr int few = 4;  // measured: 2 to 5 are alike, more or fewer are slower

  // Calls work(lane, search) for each lane.
  template <class Work>
  void one_by_one(Mask<Real> here, Work work) {
    for (unsigned left = bits(here); left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      auto own = triangles_.one(i);
      LoneMeshSearch search(mesh_, ray_.one(i), own, effort_);
      work(i, search);
      triangles_.set_one(i, own);
    }
  }
  void leaf(std::uint32_t first, std::uint32_t count, Mask<Real> here) {
    if constexpr (quick && lanes < Real >> 1) {
      if (tia::count(here) < static_cast<int>(2 * count))
        return one_by_one(here, [&](int, auto& search) { search.leaf(first, count); });
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      effort_.test();
      const TriangleHit<Real> hit = meet(first, count, i);
      triangles_.offer(hit.t, Real(static_cast<float>(mesh_.bvh.order[first + i])),
                       here && hit.inside && hit.t > Real(0));
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
  const BoxRay<Real>& box_;
  const ShearedRay<Real>& ray_;
  Triangles& triangles_;
  Effort& effort_;
};

/// Any rays, those along each axis in turn.
template <bool quick, class Real, class Triangles>
void search(const MeshIndex& mesh, const MeshRay<Real>& ray, Triangles& triangles,
            Mask<Real> active, Effort& effort) {
  if (mesh.bvh.nodes.empty()) return;
  const BoxRay<Real> box(ray.origin, ray.direction, Real(0));
  const LongestAxis<Real> longest(ray.direction);
  ShearedRay<Real> sheared(ray.origin, ray.direction, longest);
  MeshSearch<Real, Triangles, quick> search(mesh, box, sheared, triangles, effort);
  const Bundle bundle(box, active);
  if constexpr (quick && lanes < Real >> 1) {
    if (bundle.scattered()) return search.alone(longest, active);
  }
  const Mask<Real> groups[] = {longest.x, longest.y, !longest.x && !longest.y};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Mask<Real> here = active && groups[axis];
    if (!any(here)) continue;
    sheared.turn_to(axis);
    search.through(bundle, here);
  }
}

}  // namespace tia
