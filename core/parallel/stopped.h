// Stopped: how a call ends whose caller no longer wants the answer. Where it looks for that, it
// also lets others go first.
#pragma once

#include <exception>
#include <stop_token>

namespace tia {

/// Stopped: the work was told to stop; it has no result.
class Stopped : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped"; }
};

/// Courtesy: who decides whether others may go first, wherever work could be stopped.
class Courtesy {
 public:
  virtual ~Courtesy() = default;
  /// Returns when it is the caller's turn again. Errors: Stopped once nobody wants the work.
  virtual void let_others_go() = 0;
};
/// Of the work that this thread does; null: it waits for nobody.
constinit inline thread_local Courtesy* courtesy = nullptr;

/// Lets others go first where that is due. Errors: Stopped, where the work has a courtesy.
inline void give_way() {
  if (courtesy != nullptr) courtesy->let_others_go();
}

/// Lets others go first where that is due. Errors: Stopped once that is asked for.
inline void end_if_asked(const std::stop_token& stop) {
  give_way();
  if (stop.stop_requested()) throw Stopped();
}

}  // namespace tia
