// What ends a picture early, after a whole round of samples.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <limits>

namespace tia {

/// Budget: what a render may take. It keeps the last round that all pixels have had within it.
struct Budget {
  std::int64_t max_rays = std::numeric_limits<std::int64_t>::max();
  /// Whether there is time for so many times the work that is done already; of 0, whether there is
  /// any left. Any thread may ask. Time is the host's.
  std::function<bool(double more)> has_time = [](double) { return true; };
};

/// BudgetSpent: there was not enough of a budget for one round.
class BudgetSpent : public std::exception {
 public:
  enum class Of { time, rays };
  explicit BudgetSpent(Of of) : of_(of) {}
  Of of() const { return of_; }
  const char* what() const noexcept override { return "no round within the budget"; }

 private:
  Of of_;
};

}  // namespace tia
