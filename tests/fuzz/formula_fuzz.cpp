// Any text as a formula: it has faults with a column each, or it is a program whose eight numbers
// at once are those of each, and whose intervals hold its values.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>

#include "core/formulas/parse.h"

namespace {

using namespace tia;

void must(bool holds) {
  if (!holds) std::abort();
}

/// Eight boxes, and a point in each, that are the text's own.
struct Boxes {
  std::array<std::array<double, 8>, 3> low{}, high{}, point{};

  explicit Boxes(const std::string& text) {
    std::mt19937_64 engine(std::hash<std::string>{}(text));
    const auto unit = [&] { return static_cast<double>(engine() >> 11U) * 0x1p-53; };
    for (std::size_t i = 0; i < 8; ++i) {
      const double size = std::ldexp(1.0, static_cast<int>(engine() % 40) - 30);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis][i] = std::floor(8 * unit()) - 4 + (engine() % 2 == 0 ? 0 : unit());
        high[axis][i] = low[axis][i] + (engine() % 8 == 0 ? 0 : size);
        const double share = engine() % 4 == 0 ? static_cast<double>(engine() % 2) : unit();
        point[axis][i] = std::clamp(low[axis][i] + share * (high[axis][i] - low[axis][i]),
                                    low[axis][i], high[axis][i]);
      }
    }
  }
};

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void check(const Program& program, const Boxes& boxes) {
  const auto eight = [](const std::array<double, 8>& all) {
    return Octet::load_unaligned(all.data());
  };
  std::array<Octet, 3> points;
  std::array<Interval<Octet>, 3> sides;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    points[axis] = eight(boxes.point[axis]);
    sides[axis] = {eight(boxes.low[axis]), eight(boxes.high[axis])};
  }
  const Octet values = evaluate(program, points.data());
  Definedness<Octet> where;
  const Interval<Octet> all = evaluate(program, sides.data(), where);
  for (int i = 0; i < 8; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const std::array<double, 3> p{boxes.point[0][at], boxes.point[1][at], boxes.point[2][at]};
    const double own = evaluate(program, p.data());
    must(same(own, lane(values, i)));
    const std::array<Dual<double, 3>, 3> dual{Dual<double, 3>::variable(p[0], 0),
                                              Dual<double, 3>::variable(p[1], 1),
                                              Dual<double, 3>::variable(p[2], 2)};
    must(same(own, evaluate(program, dual.data()).value));
    if (!std::isfinite(own)) continue;
    must((bits(where.some) >> i & 1) != 0);
    must(lane(all.lo, i) <= own && own <= lane(all.hi, i));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  Faults faults;
  ProgramBuilder builder;
  const int term =
      read_formula(text, {{"x", "y", "z"}, {{"a", 0.5}, {"big", 1e200}}}, {}, builder, faults);
  must(faults.empty() == (term >= 0));
  if (term >= 0) check(builder.program({term}), Boxes(text));
  try {
    faults.raise();
  } catch (const InputError& error) {
    for (const Fault& each : error.faults()) must(each.column >= 1 && each.column <= size + 1);
  }
  return 0;
}
