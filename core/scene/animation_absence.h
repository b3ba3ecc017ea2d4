// What is not in a scene at a time: elements of its lists.
#pragma once

#include <vector>

#include "core/scene/animation_target.h"

namespace tia {

/// Absence: the paths of elements that are taken out.
class Absence {
 public:
  Absence() = default;
  /// Domain: each the path of an element of a list, no two the same.
  explicit Absence(std::vector<TargetPath> paths);
  /// Whether a place is in one of them.
  bool has(const TargetPath& path) const;
  void erase_from(Value& scene) const;
  /// Where what is at this path afterwards has been before.
  TargetPath before(TargetPath path) const;

 private:
  std::vector<TargetPath> paths_;  // in the order in which they are erased
};

}  // namespace tia
