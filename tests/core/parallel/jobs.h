// What the tests of sharing measure their jobs by.
#pragma once

#include "core/parallel/turns.h"

namespace tia::test {

inline constexpr Nanoseconds ms = 1'000'000;
inline constexpr int endless = 1'000'000'000;  ///< tasks that no test sees the last of

}  // namespace tia::test
