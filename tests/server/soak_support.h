// What the soak tests share: how long they are, and what a process holds and counts.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <map>

#include "tests/server/http/wire.h"
#include "tests/server/process_support.h"

namespace tia::test {

/// How many times longer than usual the tests are: the environment's TIA_SOAK.
inline double scale() {
  const char* text = std::getenv("TIA_SOAK");
  return text == nullptr ? 1 : std::max(1.0, std::atof(text));
}
inline int scaled(int count) { return static_cast<int>(count * scale()); }

// ---- what the process holds -----------------------------------------------------------------

inline long kilobytes(const Process& tia) {
  std::istringstream lines(file_bytes(tia.proc("status")));
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("VmRSS:")) return std::stol(line.substr(6));
  throw std::runtime_error("no VmRSS");
}
inline std::ptrdiff_t entries(const Process& tia, const char* folder) {
  const std::filesystem::directory_iterator all(tia.proc(folder));
  return std::distance(begin(all), end(all));
}

// Counters by their name and labels, as /metrics writes them.
inline std::map<std::string, double> counters(const Tia& tia) {
  std::map<std::string, double> all;
  std::istringstream lines(tia.get("/metrics").body);
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with('#'))
      all[line.substr(0, line.rfind(' '))] = std::stod(line.substr(line.rfind(' ')));
  return all;
}

inline const std::string small_picture = "/render?width=64&height=48&format=pfm";

}  // namespace tia::test
