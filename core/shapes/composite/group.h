// Objects that belong together: one transform, one material for those without their own, and
// optionally a grid of copies that share one copy in memory.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/input/errors.h"
#include "core/input/fields.h"
#include "core/math/aabb.h"

namespace tia {

struct Object;

/// Repeat: copies at i * step.x, j * step.y, k * step.z along x, y, z. Shape: count[0] x count[1] x
/// count[2] copies. Space/units: the group's own space, before its transform.
struct Repeat {
  static constexpr std::int64_t most = 16'777'216;
  std::array<int, 3> count{1, 1, 1};
  Vec3d step{};

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit(
        "count", &Repeat::count,
        Spec{.about = "copies along x, y and z", .min = 1, .max = double(most), .required = true});
    visit("step", &Repeat::step,
          Spec{.about = "from one copy to the next along x, y and z", .min = -1e9, .max = 1e9});
  }
  /// Copies in one place.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Repeat&) const = default;

  /// How many; most + 1 where they are more than most.
  std::int64_t copies() const;
  /// How far copy (i, j, k) is from the first.
  Vec3d offset(int i, int j, int k) const { return {i * step.x, j * step.y, k * step.z}; }
  /// The box around all copies of a box.
  Aabb swept(const Aabb& box) const;
};

struct Group {
  static constexpr std::string_view type = "group";
  static constexpr bool one_object = false;
  std::vector<Object> children;
  std::optional<Repeat> repeat;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("children", &Group::children, Spec{.about = "objects", .required = true, .min_items = 1});
    visit("repeat", &Group::repeat, Spec{.about = "a grid of copies"});
  }
  bool operator==(const Group&) const;
};
inline const std::vector<Object>& children_in(const Group& group) { return group.children; }

}  // namespace tia
