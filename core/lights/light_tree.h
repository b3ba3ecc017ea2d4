// LightTree: one of many lights, by how much each may give a point, in as many steps as the tree is
// deep.
#pragma once

#include <vector>

#include "core/math/aabb.h"

namespace tia {

/// LightBounds: where one or several lights are and how much they shine whereto: within `cos_o` of
/// the axis are all directions that they face, and within cos_e of those all that they shine in.
struct LightBounds {
  Aabb box{};
  double power = 0;
  Vec3d axis{0, 0, 1};
  double cos_o = -1, cos_e = 0;
  bool two_sided = false;

  /// About how much a surface at p with the normal n, to either side, may get; 0 where it gets
  /// none; of n = 0, a point within a medium. Domain: else a unit normal.
  double importance(const Vec3d& p, const Vec3d& n) const;
};
LightBounds around(const LightBounds& a, const LightBounds& b);

/// Source: Conty Estevez, Kulla, "Importance sampling of many lights with adaptive tree splitting",
/// Proc. ACM Comput. Graph. Interact. Tech. 1(2) (2018), without the splitting; Pharr, Jakob,
/// Humphreys, "Physically Based Rendering", 4th ed., 12.6.3.
class LightTree {
 public:
  LightTree() = default;
  /// Lights without power are never chosen. Cost: O(n log n).
  explicit LightTree(const std::vector<LightBounds>& lights);

  struct Choice {
    int light = -1;  ///< -1: none gives the point anything
    double chance = 0;
  };
  Choice choose(const Vec3d& p, const Vec3d& n, double u) const;
  /// The chance that choose() has for that light.
  double chance(int light, const Vec3d& p, const Vec3d& n) const;

 private:
  struct Node {
    LightBounds bounds;
    int parent = -1;
    int left = -1, right = -1;
    int light = -1;  ///< of a leaf
  };
  using Range = std::vector<int>::iterator;
  int build(const std::vector<LightBounds>& lights, Range from, Range to, int parent);

  std::vector<Node> nodes_;
  std::vector<int> leaf_of_;  // each light's node; -1: none
};

}  // namespace tia
