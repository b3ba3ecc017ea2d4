#include "core/accel/world/solid.h"

#include <algorithm>

#include "core/parallel/per_thread.h"

namespace tia {
namespace {

// How far apart along the line two faces may be to count as one: 2^12 roundings of double of the
// origin's distance, for roots lose some digits, those of high degree most.
double same_distance(const Line& line) {
  const Vec3d& o = line.origin;
  const double reach = std::max({std::fabs(o.x), std::fabs(o.y), std::fabs(o.z)});
  return 0x1p-40 * reach / length(line.direction);
}

}  // namespace

const Spans& spans(const Solid& solid, std::span<const Primitive> primitives, const Line& line,
                   WorkCounter& work) {
  auto& stack = per_thread<std::vector<Spans>, struct BetweenSteps>();
  auto& result = per_thread<Spans, struct OfStep>();
  std::size_t top = 0;
  const double same = same_distance(line);
  for (const Solid::Step& step : solid.steps) {
    if (step.primitive >= 0) {
      if (top == stack.size()) stack.emplace_back();
      Spans& own = stack[top++];
      own.clear();
      const Primitive& primitive = primitives[static_cast<std::size_t>(step.primitive)];
      work.add(spans(primitive, line, [&](double t, int element) {
        own.push_back({t, primitive_of(primitive, step.primitive, element), element});
      }));
    } else {
      --top;
      work.add(static_cast<std::int64_t>((stack[top - 1].size() + stack[top].size()) / 4));
      merge(step.operation, stack[top - 1], stack[top], same, result);
      stack[top - 1].swap(result);
    }
  }
  return stack.front();
}

}  // namespace tia
