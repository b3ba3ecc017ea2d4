// Lone: work that cannot be shared among threads, but gives way to others' as tasks do.
#pragma once

#include <functional>
#include <stop_token>

#include "core/parallel/hands.h"

namespace tia {

/// Lone: a caller that does its one task alone, which is not over until all of it is done.
class Lone {
 public:
  Lone(Hands& hands, const std::stop_token& stop, Flow& flow);
  ~Lone();
  Lone(const Lone&) = delete;
  Lone& operator=(const Lone&) = delete;

  /// What this thread does at present; null: nothing that is alone.
  static Lone* present();
  /// When it is its turn. Errors: Stopped; what `work` throws.
  void work(const std::function<void()>& work);
  /// Lets `work` take turns of its own meanwhile. What it throws ends the lone work, too.
  void aside(const std::function<void()>& work);

 private:
  void take_turn();
  void rest();

  Hands& hands_;
  Job job_;
  bool is_at_work_ = false;
};

}  // namespace tia
