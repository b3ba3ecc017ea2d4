#include "core/scene/projections/module_slice.h"

#include <algorithm>
#include <array>

namespace tia {

// Of two that are as near, the left one.
double ModuleSlice::nearest(double x) const {
  const auto after = std::ranges::upper_bound(*modules, x);
  if (after == modules->begin()) return *after;
  const double before = *(after - 1);
  return after != modules->end() && *after - x < x - before ? *after : before;
}

Octet ModuleSlice::nearest(const Octet& x) const {
  std::array<double, Octet::size> each;
  x.store_unaligned(each.data());
  for (double& at : each) at = nearest(at);
  return Octet::load_unaligned(each.data());
}

}  // namespace tia
