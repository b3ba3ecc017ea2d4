#include "tests/server/load/soak_support.h"

#include <algorithm>
#include <cstdlib>

namespace tia::test {

double scale() {
  const char* text = std::getenv("SOAK");
  return text == nullptr ? 0.5 : std::max(0.5, std::atof(text));
}
int scaled(int count) { return static_cast<int>(count * scale()); }

std::map<std::string, double> counters(const Tia& tia) {
  return series_of(tia.get("/metrics").body);
}

}  // namespace tia::test
