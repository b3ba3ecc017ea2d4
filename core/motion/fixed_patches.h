// FixedPatches: the contact patches of all fixed things, and a search for those near a box.
#pragma once

#include <cstdint>
#include <vector>

#include "core/boxes/bvh.h"
#include "core/motion/contact_patch.h"
#include "core/motion/exact.h"

namespace tia {

/// FixedPatches: each patch belongs to a fixed thing; the endless ones stand apart from the tree.
class FixedPatches {
 public:
  explicit FixedPatches(const std::vector<FixedShape>& fixed);

  std::size_t count() const { return patches_.size(); }
  const ContactPatch& patch(std::size_t i) const { return patches_[i]; }
  const std::vector<ContactPatch>& all() const { return patches_; }
  /// The number of the fixed thing that it is a part of.
  std::size_t owner(std::size_t i) const { return owners_[i]; }
  /// Around all that is not endless; empty where nothing is.
  const Aabb& bounds() const { return bounds_; }

  /// Calls visit(i) for each patch whose box meets a box, in ascending order.
  template <class Visit>
  void for_each_near(const Aabb& box, Visit visit) const {
    std::vector<std::uint32_t>& found = found_;
    found.clear();
    gather(box, found);
    for (const std::uint32_t i : found) visit(i);
  }

 private:
  void gather(const Aabb& box, std::vector<std::uint32_t>& found) const;

  std::vector<ContactPatch> patches_;
  std::vector<std::size_t> owners_;
  std::vector<std::uint32_t> endless_, bounded_;
  Aabb bounds_;
  Bvh tree_;  // of the bounded
  mutable std::vector<std::uint32_t> found_;
};

/// The patches of one fixed thing.
std::vector<ContactPatch> patches_of(const FixedShape& shape);

}  // namespace tia
