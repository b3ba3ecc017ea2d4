// Stopped: how a call ends whose caller no longer wants the answer.
#pragma once

#include <exception>
#include <stop_token>

namespace tia {

/// Stopped: the work was told to stop; it has no result.
class Stopped : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped"; }
};

/// Errors: Stopped once that is asked for.
inline void end_if_asked(const std::stop_token& stop) {
  if (stop.stop_requested()) throw Stopped();
}

}  // namespace tia
