// Work that a pool does not share among threads.
#pragma once

#include "core/parallel/pool_job.h"

namespace tia {

/// Lone: a caller that does its one task alone, which is not over until all of it is done.
class Pool::Lone {
 public:
  Lone(Pool& pool, const std::stop_token& stop, Flow& flow)
      : pool_(pool), job_(pool, 1, 1, stop, nothing, flow, true) {
    const std::lock_guard lock(pool_.mutex_);
    pool_.turns_.enter(job_, pool_.clock_());
    pool_.call_hands();
  }
  ~Lone() {
    std::unique_lock lock(pool_.mutex_);
    if (at_work_) rest();
    if (job_.caller.job != nullptr) pool_.unseat(job_.caller);
    job_.next = job_.count;
    pool_.turns_.leave(job_, pool_.clock_());
    pool_.call_hands();
  }
  Lone(const Lone&) = delete;
  Lone& operator=(const Lone&) = delete;

  void work(const std::function<void()>& work) {
    take_turn();
    work();
  }
  /// Lets `work` take turns of its own meanwhile. What it throws ends the lone work, too.
  void aside(const std::function<void()>& work) {
    std::unique_lock lock(pool_.mutex_);
    rest();
    pool_.unseat(job_.caller);
    Turns::pause(job_, pool_.clock_());
    pool_.call_hands();
    lock.unlock();
    work();
    lock.lock();
    Turns::resume(job_);
    pool_.call_hands();
    lock.unlock();
    take_turn();
  }

 private:
  void take_turn() {
    std::unique_lock lock(pool_.mutex_);
    Hand& hand = job_.caller;
    while (hand.job == nullptr) {
      if (job_.stop.stop_requested()) throw Stopped();
      pool_.wait(hand, lock, job_.stop, [&] { return hand.job != nullptr; });
    }
    pool_.begin(hand);
    at_work_ = true;
    inside_task = true, courtesy = &hand, lone = this;
  }
  void rest() {
    inside_task = false, courtesy = nullptr, lone = nullptr;
    pool_.tell(job_.caller);
    Turns::end(job_, job_.caller.since);
    at_work_ = false;
  }

  static inline const std::function<void(int)> nothing;
  Pool& pool_;
  Job job_;
  bool at_work_ = false;
};

}  // namespace tia
