#include "core/radio/radio_path.h"

#include <algorithm>
#include <tuple>

namespace tia {

bool comes_before(const RadioPath& a, const RadioPath& b) {
  if (a.length != b.length) return a.length < b.length;
  const auto sequence = [](const RadioInteraction& x, const RadioInteraction& y) {
    return std::tie(x.body, x.element, x.kind) < std::tie(y.body, y.element, y.kind);
  };
  return std::lexicographical_compare(a.interactions.begin(), a.interactions.end(),
                                      b.interactions.begin(), b.interactions.end(), sequence);
}

}  // namespace tia
