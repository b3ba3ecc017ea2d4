// The plan of walls: their runs, and how much of each its corners take. Heights do not matter here.
#pragma once

#include <vector>

#include "core/shapes/composite/walls.h"

namespace tia {

/// WallRun: walls from one point of the line to the next. Space/units: scene units; x and z.
struct WallRun {
  Walls::Point start{}, way{};   ///< its first point, and a unit vector along it
  double length = 0, begin = 0;  ///< of it, and of the line before it
  double low = 0, high = 0;      ///< where its corners leave off, along it
  double from = 0, to = 0;       ///< where its own boxes begin and end, along it

  /// The point at `along` the run and `aside` of it; positive: from x towards z.
  Walls::Point at(double along, double aside) const {
    return {start[0] + along * way[0] - aside * way[1], start[1] + along * way[1] + aside * way[0]};
  }
};

/// WallCorner: where a run meets the next one in neither a straight line nor a right angle: a kite
/// between both. Shape: its four points, clockwise as seen from above (from z towards x).
using WallCorner = std::array<Walls::Point, 4>;

/// WallPlan: runs in the line's order; `corners[k]` is at the end of run k, none where it has none.
/// At a right angle the run before the corner has all of it.
struct WallPlan {
  std::vector<WallRun> runs;
  std::vector<std::optional<WallCorner>> corners;
};

/// Errors: as faults at `points`: too many, points that coincide, a run that is shorter than what
/// its corners take of it, runs that are in each other's way. The plan is of use without faults.
/// Source: the inner and outer side of a turn by phi meet h tan(phi / 2) before and behind its
/// point, h half the thickness.
WallPlan wall_plan(const Walls& walls, const Place& at, Faults& faults);

}  // namespace tia
