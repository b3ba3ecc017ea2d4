// Who may draw, and when: a bounded number of pictures at once, light ones never behind heavy ones.
#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <list>
#include <mutex>
#include <stop_token>
#include <utility>

namespace tia::server {

/// Admission: gives out tickets. Any thread may call. At most half of them (but one) go to heavy
/// work, so that a light picture need not wait for posters to end; where both kinds wait, a light
/// one goes first, unless no heavy one is at work: so heavy ones go on, too. Among equals the order
/// is that of coming.
class Admission {
 public:
  /// Rays beyond which work is heavy: about seven ordinary pictures' or a quarter of a second's.
  static constexpr double most_light_rays = 1 << 21;

  /// Ticket: the right to work, until it ends.
  class Ticket {
   public:
    Ticket(Ticket&& from) noexcept : from_(std::exchange(from.from_, nullptr)), kind_(from.kind_) {}
    ~Ticket() {
      if (from_ != nullptr) from_->leave(*this);
    }

   private:
    friend Admission;
    Ticket(Admission& from, std::size_t kind) : from_(&from), kind_(kind) {}
    Admission* from_;
    std::size_t kind_;
    std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
  };

  explicit Admission(int tickets);

  /// Waits for a ticket for work that takes so many rays. Errors: Stopped.
  [[nodiscard]] Ticket enter(double rays, const std::stop_token& stop);

  int at_work() const;
  int waiting() const;
  /// When one who finds all places taken may ask again, by how long work took lately. Unit: s.
  int retry_after() const;

 private:
  enum : std::size_t { light, heavy };
  struct Kind {
    int most = 0, at_work = 0;
    std::list<int> waiting;  // one entry each, in the order of coming
  };
  bool may_enter(std::size_t kind) const;
  int all_at_work() const { return kinds_[light].at_work + kinds_[heavy].at_work; }
  void leave(const Ticket& ticket);

  const int tickets_;
  mutable std::mutex mutex_;
  std::condition_variable_any left_;
  std::array<Kind, 2> kinds_;
  double usual_s_ = 0.1;  // how long a ticket is held, a moving mean
};

}  // namespace tia::server
