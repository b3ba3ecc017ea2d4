// Solid: CSG compiled to a list of steps over primitives.
#pragma once

#include <span>
#include <vector>

#include "core/accel/world/primitive.h"
#include "core/boxes/work_counter.h"

namespace tia {

/// Solid: steps in postfix order over a stack of spans: put a primitive's spans on it, or merge the
/// two on top.
struct Solid {
  struct Step {
    int primitive = -1;  ///< -1: merge
    Operation operation = Operation::union_;
  };
  std::vector<Step> steps;
  int work = 0;  ///< what trying a ray on it costs: the sum of its primitives
};

/// What the line runs through in the solid. The reference is good until this thread's next call.
/// The work takes what it costs beyond solid.work. Errors: what the work's report throws.
const Spans& spans(const Solid& solid, std::span<const Primitive> primitives, const Line& line,
                   WorkCounter& work);

}  // namespace tia
