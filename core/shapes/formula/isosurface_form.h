// IsosurfaceForm: the surface f(x, y, z) = 0, ready to be searched, and the events that a search
// along a line reports.
#pragma once

#include <memory>

#include "core/shapes/formula/isosurface_cells.h"

namespace tia {

/// IsosurfaceForm. Surface: f = 0 within the region; inside where f < 0 within it. Where f is
/// undefined there is neither surface nor inside. Elements: 0 the surface, from 1 on the region's.
struct IsosurfaceForm {
  static constexpr bool solid = true;
  Program function;
  Region region;
  std::shared_ptr<const IsosurfaceCells> cells;
};

std::size_t heap_bytes(const IsosurfaceForm& form);

/// IsosurfaceEvent: a root of f along a line, or another change between inside and outside: a jump
/// of f past 0, or an end of where f is defined. Those bound the solid and are not of the surface.
struct IsosurfaceEvent {
  double t = 0;
  bool inside = false;  ///< after it
  bool is_root = false;
  Bracket bracket{};
  double tolerance = -1;  ///< of a root that is only bracketed, whose t is a guess; -1: t is final
};

namespace detail {

/// Gets the events along a line, in the order of t.
class IsosurfaceListener {
 public:
  /// Returns: whether to go on.
  virtual bool on_event(const IsosurfaceEvent& event) = 0;

 protected:
  ~IsosurfaceListener() = default;
};

/// IsosurfaceStretch: the part of a line that is searched. Cells that it enters beyond `enough` are
/// left out.
struct IsosurfaceStretch {
  double from, to, enough = Aabb::far;
  bool brackets_alone = false;  ///< whether roots are only bracketed, not found
};
}  // namespace detail
}  // namespace tia
