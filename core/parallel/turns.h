// Turns: which job a free thread goes to, so that clients, and then requests, share threads fairly.
// Plain bookkeeping: it starts no thread, locks nothing and is told the time.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <list>
#include <vector>

namespace tia {

using Nanoseconds = std::int64_t;

/// ServiceTime: the time that threads spend on something, which goes on while they do; `each` of
/// them may count as several.
struct ServiceTime {
  Nanoseconds before = 0;  ///< what those at work found, less the times at which they came
  int awake = 0;           ///< threads at work, as they count
  Nanoseconds at(Nanoseconds now) const { return before + awake * now; }
  void begin(Nanoseconds now, int each = 1) { awake += each, before -= each * now; }
  void end(Nanoseconds now, int each = 1) { awake -= each, before += each * now; }
  void raise_to(Nanoseconds least, Nanoseconds now) {
    if (at(now) < least) before += least - at(now);
  }
};

/// Flow: one request's jobs, one after the other; its service adds up over all of them.
struct Flow {
  std::uint64_t client = 0;             ///< whom it is for, by any number that tells clients apart
  std::vector<std::uint64_t> others{};  ///< who wait for it, too: it may become theirs
  bool is_long = false;        ///< it takes long: so foreseen, or it has had Turns::long_service
  bool is_background = false;  ///< nobody waits for it: of a client whose all is so
  Nanoseconds attained = 0;    ///< the service that it has had
  std::function<void()>
      became_long{};  ///< called once it has, by any thread, while turns are taken

  // Turns' own, from job to job.
  std::int64_t order = 0;                 ///< of its first coming; 0: it has not come yet
  Nanoseconds place = 0, credit_end = 0;  ///< its service among its client's, and up to where it
                                          ///< is within its credit
};

struct ClientJobs;

/// Turn: a job as seen from outside. Hands are the threads at it.
struct Turn {
  Turn(int tasks, int most, Flow& request) : count(tasks), most_hands(most), flow(request) {}

  const int count, most_hands;
  Flow& flow;
  std::atomic<int> next = 0;  ///< the task to be taken next
  int hands = 0;              ///< called to it
  int suspended = 0;          ///< more of them, each within a task that waits with it
  ServiceTime service{};
  ClientJobs* client = nullptr;  ///< while it is among the turns
  bool rested = false;           ///< it has been parked, without a hand, since it had its last one

  bool has_tasks() const { return next.load(std::memory_order_relaxed) < count; }
  bool wants_hand() const { return (has_tasks() || suspended > 0) && hands < most_hands; }
  bool is_over() const { return hands == 0 && suspended == 0 && !has_tasks(); }
  bool is_young(Nanoseconds now) const {
    return !flow.is_long && service.at(now) < flow.credit_end;
  }
};

/// ClientJobs: those of one client's jobs that are present.
struct ClientJobs {
  std::uint64_t number = 0;
  bool is_background = false;
  ServiceTime service{};  ///< of what is in the background `background_cost` times what it has
  Nanoseconds level = 0;  ///< the service that makes a job even with the others
  std::vector<Turn*> jobs{};
};

/// Turns. "Least attained service first", twice: a thread that is free goes to the client that has
/// had the least service, and there to the job that has had the least. So a small job overtakes a
/// big one, and many requests of one client take no more than the one of another.
///
/// Of a client's long jobs only the oldest takes part; the others are parked. What is done of them
/// stays, and they end one after the other, not all together at last.
///
/// Bounds: a thread leaves its job for one that has had less by more than `slice`; it looks for
/// such a one between tasks, and where they give way within them, every `look`.
/// A new job, or client, begins `credit` below the least of the others: so much it may have before
/// them. An endless stream of new ones starves nobody: with n present, the level that they begin
/// below rises by at least 1/2n of all service among a client's jobs, 1/4n among clients, so that
/// each job gets half of an even share or more, and each client a quarter. Among clients less is
/// kept for the old ones, for who asks for one thing after the other is new each time: somebody
/// who drags a light beside a flood.
/// No job, or client, is owed more than `arrears` when another begins: few threads save up no claim
/// to all.
/// What is in the background has 1/background_cost of a client's share, all together: its service
/// counts so many times. It begins with no credit, and what it has had is remembered while it has
/// nothing to do, so that many small jobs one after the other have no more than a large one.
///
/// At most `threads` hands at once, and up to two more at times: a young job, still within its
/// credit, that has no hand does not wait for the end of an older one's task: one such job, and one
/// of a client who has no hand at all. Then the old job that has had most leaves when it next
/// looks. Source: Kleinrock, "Queueing Systems" vol. 2 (1976), ch. 4 (foreground-background); the
/// start of new jobs after Goyal, Vin, Cheng, "Start-time fair queueing" (1996), which also has the
/// two levels.
class Turns {
 public:
  static constexpr Nanoseconds look = 250'000, slice = 2'000'000, credit = 50'000'000,
                               arrears = 1'000'000'000, long_service = 500'000'000;
  static constexpr int background_cost = 8;

  explicit Turns(int threads) : threads_(threads) {}
  int threads() const { return threads_; }

  void enter(Turn& job, Nanoseconds now);
  void leave(Turn& job, Nanoseconds now);
  /// That this client waits for the flow, too. It becomes that of whom it comes sooner for, as if
  /// that one had just asked for it: now, at its next job, or when it has become long.
  void also_for(Flow& flow, std::uint64_t client, Nanoseconds now);
  /// While another job of its flow goes on for one that stays among the turns, and keeps its
  /// client there, but wants no hand. Domain: it has none.
  static void pause(Turn& job, Nanoseconds now);
  static void resume(Turn& job);
  /// Returns: the job that one more hand should go to, of those that `can` have one; or null.
  using Can = std::function<bool(Turn& job)>;
  Turn* next(Nanoseconds now, const Can& can) const;
  /// Whether a hand goes on with its job, as long as that has tasks.
  bool stays(const Turn& job, Nanoseconds now) const;

  void call(Turn& job, Nanoseconds now);  ///< a hand to it
  void dismiss(Turn& job);                ///< a hand that is not at work
  static void begin(Turn& job, Nanoseconds now);
  static void end(Turn& job, Nanoseconds now);
  /// That a hand was at work for so long.
  void spend(Turn& job, Nanoseconds time, Nanoseconds now);

 private:
  ClientJobs* find(std::uint64_t client);
  ClientJobs& client_of(std::uint64_t number, bool is_background, Nanoseconds now);
  void join(Turn& job, ClientJobs& client, Nanoseconds now);
  bool would_be_sooner(const Flow& flow, std::uint64_t client, Nanoseconds now);
  void choose_client(Flow& flow, Nanoseconds now);
  void move(Flow& flow, std::uint64_t client, Nanoseconds now);
  static int extra_hands(const Turn& job, Nanoseconds now);
  bool has_had_most(const Turn& job, Nanoseconds now) const;
  template <class Action>
  void for_each_candidate(const Action& action) const;

  const int threads_;
  std::list<ClientJobs> clients_;
  int hands_ = 0;             // of all jobs
  Nanoseconds level_ = 0;     // the service that makes a client even with the others
  std::int64_t entered_ = 0;  // flows, ever
};

}  // namespace tia
