// Whether a sanitizer watches the libraries that are tested. Tests are compiled once for several
// builds of them, so that they have to ask.
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <vector>

// The sanitizers', where the program has one.
// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming)
extern "C" void __asan_init() __attribute__((weak));
extern "C" void __tsan_init() __attribute__((weak));
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)

namespace tia::test {

/// Whether a sanitizer watches, which takes ten times as long, and memory and descriptors of its
/// own. A function: whose turn a variable of a header is at the start is not certain.
inline bool sanitized() { return __asan_init != nullptr || __tsan_init != nullptr; }

/// So many rounds of a test, or a share of them under a sanitizer.
inline int rounds(int n, int share = 20) { return sanitized() ? std::max(1, n / share) : n; }

/// The cases of a test, or the last `watched` of them under a sanitizer: where they differ in
/// numbers, and run the same code.
template <class T>
std::vector<T> cases(std::initializer_list<T> all, std::size_t watched = 1) {
  const auto few = static_cast<std::ptrdiff_t>(std::min(watched, all.size()));
  return {sanitized() ? all.end() - few : all.begin(), all.end()};
}

}  // namespace tia::test
