// A program that is given bytes as they are made, and whose answer is taken as it comes.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "server/operation/child.h"

namespace tia::server {

/// ChildLimits: the most that such a program may take; beyond them the system kills it, or gives it
/// no more. It writes no file.
struct ChildLimits {
  std::uint64_t memory_bytes = std::uint64_t{2} << 30U;  ///< address space
  unsigned cpu_s = 600;
};

/// ChildFilter: one that runs, until the end of this. What it says on standard error nobody hears.
class ChildFilter {
 public:
  /// Errors: std::system_error where it cannot be started.
  ChildFilter(const std::string& program, const std::vector<std::string>& arguments,
              const ChildLimits& limits);

  /// Sends the bytes. Returns: what it has written by then; never waits for that alone, but takes
  /// it while it waits for the program to read. Errors: Stopped; std::runtime_error where it has
  /// ended.
  std::string pass(std::string_view bytes, const std::stop_token& stop);
  /// Says that no more will come. Returns: what it writes until its end.
  /// Errors: Stopped; std::runtime_error where it ends by a signal or with another status than 0.
  std::string finish(const std::stop_token& stop);

 private:
  void take(std::string& output);
  StartedChild started_;
  bool has_ended_ = false;  // its output
};

}  // namespace tia::server
