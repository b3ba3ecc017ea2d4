// What a surface f = 0 is made of, and what its search along a line tells.
#pragma once

#include <memory>

#include "core/shapes/formula/field_cells.h"

namespace tia {

/// FieldForm. Surface: f = 0 within the region; inside where f < 0 within it. Where f is undefined
/// it has neither. Its elements: 0 the surface itself, 1 and up the region's.
struct FieldForm {
  static constexpr bool solid = true;
  Program field;
  Region region;
  std::shared_ptr<const FieldCells> cells;
};

std::size_t heap_bytes(const FieldForm& form);

/// FieldEvent: something happens to the field along a line. A jump, where f passes 0 without being
/// it, and an edge of where it is defined bound the solid, but are no surface.
struct FieldEvent {
  double t = 0;
  bool inside = false;  ///< after it
  bool is_root = false;
  Bracket bracket{};
  double tolerance = -1;  ///< of a root that is only bracketed, t what it is guessed to be; of
                          ///< others below 0
};

namespace detail {

/// Told of what happens along a line, in order.
class FieldListener {
 public:
  /// Returns: whether to go on.
  virtual bool hear(const FieldEvent& event) = 0;

 protected:
  ~FieldListener() = default;
};

/// FieldStretch: what of a line is searched. Cells that it enters beyond `enough` are not.
struct FieldStretch {
  double from, to, enough = Aabb::far;
  bool brackets_alone = false;  ///< whether roots need not be found in their brackets
};
}  // namespace detail
}  // namespace tia
