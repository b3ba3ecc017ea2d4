// How a round of a picture ends that goes beyond what there is.
#pragma once

#include <cstdint>
#include <optional>

#include "core/render/budget.h"
#include "core/render/meter.h"
#include "core/scene/limits.h"

namespace tia {

/// OutOfBudget: thrown within a round, which then does not count.
struct OutOfBudget {
  enum { time, rays, limit_of_rays, limit_of_work } what;
};

/// HostLimits: what the host allows at most, of rays and of tests.
struct HostLimits {
  std::int64_t rays, work;
};

/// Ends a round that goes beyond the budget. What the host allows at most is one, too, where there
/// is one: who asks for as much as there is time for is given that. `told` hears of all that is
/// spent; both outlive it.
inline Spent spent_within(const std::optional<Budget>& budget, const Spent& told,
                          HostLimits limits) {
  if (!budget) return told;
  return [&budget, &told, limits](std::int64_t rays, std::int64_t tests) {
    if (told) told(rays, tests);
    if (rays > budget->max_rays) throw OutOfBudget{OutOfBudget::rays};
    if (rays > limits.rays) throw OutOfBudget{OutOfBudget::limit_of_rays};
    if (tests > limits.work) throw OutOfBudget{OutOfBudget::limit_of_work};
    if (!budget->has_time(0)) throw OutOfBudget{OutOfBudget::time};
  };
}

/// What it is called where there is no picture without that round.
/// Errors: BudgetSpent; InputError (limit).
[[noreturn]] inline void refuse(const OutOfBudget& end, HostLimits limits) {
  switch (end.what) {
    case OutOfBudget::time: throw BudgetSpent(BudgetSpent::Of::time);
    case OutOfBudget::rays: throw BudgetSpent(BudgetSpent::Of::rays);
    case OutOfBudget::limit_of_rays: throw too_many_rays("a first round of more", limits.rays);
    case OutOfBudget::limit_of_work: break;
  }
  throw too_much_work(limits.work);
}

}  // namespace tia
