// What the tests of formulas' surfaces share: the short way from a text to a form, and from a line
// to what it meets.
#pragma once

#include "core/shapes/formula/explicit.h"
#include "core/shapes/formula/implicit.h"
#include "tests/core/shapes/lines.h"

namespace tia::test {

using Parameters = std::map<std::string, double>;

inline IsosurfaceForm implicit(const std::string& f, const Bounds& bounds,
                               const Parameters& parameters = {}) {
  return prepare(Implicit{f, bounds, parameters});
}

/// What of t is inside a box or a ball around the line, ascending.
inline std::vector<double> clipped(std::vector<double> t, double from, double to) {
  std::sort(t.begin(), t.end());
  std::erase_if(t, [&](double each) { return each < from || each > to; });
  return t;
}

}  // namespace tia::test
