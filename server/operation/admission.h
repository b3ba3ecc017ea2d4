// Who may read a long text and who may draw, and when: a bounded number at once, light work never
// behind heavy work.
#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <list>
#include <mutex>
#include <stop_token>
#include <utility>

#include "server/problem.h"

namespace tia::server {

/// Admission: gives out tickets. Any thread may call. Heavy work begins with at most half of them
/// (but one), and a quarter of the queue, so that a light picture need not wait for posters to end;
/// where both kinds wait, a light one goes first, unless no heavy one is at work: so heavy ones go
/// on, too. Among equals the order is that of coming.
class Admission {
 public:
  /// Rays, or tests of them, beyond which work is heavy: about seven ordinary pictures' or a
  /// quarter of a second's.
  static constexpr std::int64_t most_light_rays = 1 << 21, most_light_tests = 1 << 25;
  /// A text beyond it is long: some milliseconds to read. Unit: bytes.
  static constexpr std::size_t longest_short_text = 64 << 10;

  /// Ticket: the right to work, until it ends.
  class Ticket {
   public:
    Ticket(Ticket&& from) noexcept
        : from_(std::exchange(from.from_, nullptr)), kind_(from.kind_), since_(from.since_) {}
    ~Ticket() {
      if (from_ != nullptr) from_->leave(*this);
    }
    /// Tells what has been done so far. Light work that turns out heavy from then on takes no light
    /// one's place. Any thread may call. Errors: HttpError (busy) where there are as many such
    /// already as there are tickets, and light work waits.
    void has_done(std::int64_t rays, std::int64_t tests) {
      if (rays > most_light_rays || tests > most_light_tests) from_->turn_heavy(*this);
    }

   private:
    friend Admission;
    Ticket(Admission* from, std::size_t kind) : from_(from), kind_(kind) {}
    Admission* from_;  // null: of work that needs none
    std::size_t kind_;
    std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
  };

  /// `queue`: how many may wait in all, for which others see to it.
  explicit Admission(int tickets, int queue = 64);

  /// Waits for a ticket to read a text of so many bytes: long ones a few at a time, for they take
  /// many times their size of memory. Errors: as enter().
  [[nodiscard]] Ticket read(std::size_t bytes, const std::stop_token& stop);
  /// Waits for a ticket for work that takes so many rays. Errors: Stopped; HttpError (busy) where
  /// all places to wait for its kind are taken.
  [[nodiscard]] Ticket enter(double rays, const std::stop_token& stop);

  int at_work() const;
  int waiting() const;
  /// When one who finds all places taken may ask again, by how long work took lately. Unit: s.
  int retry_after() const;

 private:
  enum : std::size_t { reading, light, heavy };
  struct Kind {
    int most = 0, most_waiting = 0;
    double usual_s = 0;  // how long a ticket is held, a moving mean
    int at_work = 0;
    std::list<int> waiting = {};  // one entry each, in the order of coming
  };
  Ticket enter_as(std::size_t kind, const std::stop_token& stop);
  bool may_enter(std::size_t kind) const;
  int light_places_taken() const;
  void turn_heavy(Ticket& ticket);
  void leave(const Ticket& ticket);
  int wait_s() const;
  HttpError busy(const char* why) const;

  mutable std::mutex mutex_;
  std::condition_variable_any left_;
  std::array<Kind, 3> kinds_;
};

}  // namespace tia::server
