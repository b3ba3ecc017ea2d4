#include "tests/server/soak_support.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace tia::test {

double scale() {
  const char* text = std::getenv("TIA_SOAK");
  return text == nullptr ? 1 : std::max(1.0, std::atof(text));
}
int scaled(int count) { return static_cast<int>(count * scale()); }

long kilobytes(const Process& tia) {
  std::istringstream lines(file_bytes(tia.proc("status")));
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("VmRSS:")) return std::stol(line.substr(6));
  throw std::runtime_error("no VmRSS");
}
std::ptrdiff_t entries(const Process& tia, const char* folder) {
  const std::filesystem::directory_iterator all(tia.proc(folder));
  return std::distance(begin(all), end(all));
}

std::map<std::string, double> counters(const Tia& tia) {
  return series_of(tia.get("/metrics").body);
}

}  // namespace tia::test
