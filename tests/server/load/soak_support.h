// What the soak tests share: how long they are, and what a server counts.
#pragma once

#include <map>
#include <string>

#include "tests/server/http/wire.h"
#include "tests/server/process_support.h"

namespace tia::test {

/// How many times longer than in CI the tests are: the environment's SOAK, else half as long.
double scale();
int scaled(int count);

/// What /metrics says.
std::map<std::string, double> counters(const Tia& tia);

inline constexpr const char* small_picture = "/render?width=64&height=48&format=pfm";

}  // namespace tia::test
