// LightTree: one of many lights, by how much each may give a point, in as many steps as the tree is
// deep.
#pragma once

#include <array>
#include <vector>

#include "core/lights/light_bounds.h"

namespace tia {

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
  struct Node;  // of the binary tree while it is built
  /// What follows where a lane of a family is chosen: one of the family's own pairs, another
  /// family, or the light that it is.
  struct Child {
    enum Kind { pair, family, light };
    Kind kind = light;
    int index = -1;
  };
  /// Family: the two children of a node of the binary tree in lanes 0 and 1, and theirs in lanes 2
  /// and 3, 4 and 5, so that a register holds whole pairs.
  struct Family {
    static constexpr std::size_t words = 12, lanes = 8;
    std::array<std::array<double, lanes>, words> word{};  ///< light_importance.h: words_of
    std::array<Child, 6> children{};
    int parent = -1;  ///< lanes * that family + the lane in it; -1: of the root
  };
  class Weights;
  int pack(const std::vector<Node>& nodes, int node, int parent);
  void put(const std::vector<Node>& nodes, int node, int family, std::size_t lane);

  std::vector<Family> families_;
  std::vector<int> leaf_of_;  // lanes * each light's family + its lane; -1: none
};

}  // namespace tia
