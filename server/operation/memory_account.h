// Memory as a budget: one account for the process (TIA_MEMORY_BYTES), and of every request a claim
// on it. What does not fit waits or is refused, by the account and not by the kernel.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <mutex>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "server/http/error.h"

namespace tia::server {

/// MemoryAccount: what the program may take, and what has how much of it. Any thread may call.
class MemoryAccount {
 public:
  /// Who waits longer for memory is refused: what holds it may itself wait for this one.
  static constexpr std::chrono::seconds most_wait{2};
  /// What memory is held for. The rows of `tia_memory_bytes`.
  enum Holder : std::size_t {
    program,
    connections,
    requests,
    pictures,
    geometries,
    scenes,
    pressed,
    models,
    read_models,
    jobs
  };
  static constexpr std::array<std::string_view, 10> holders{
      "program", "connections", "requests", "pictures",    "geometries",
      "scenes",  "pressed",     "models",   "read_models", "jobs"};
  /// The program itself with its libraries, tables, gallery and the stacks of its threads, and what
  /// the allocator holds beyond what it has given out. Unit: bytes.
  static constexpr std::int64_t program_bytes = 64 << 20;

  explicit MemoryAccount(std::int64_t limit_bytes);

  std::int64_t limit() const { return limit_; }
  std::int64_t held(Holder by) const { return held_[by]; }
  std::int64_t free() const { return limit_ - total_; }
  /// The most that one request may have: an eighth is kept for small ones, and kept scenes and
  /// models, which are nobody's to give, stay. However much they hold, a small one may have its
  /// own.
  std::int64_t most_of_one() const {
    return std::max(most_small(),
                    limit_ - held_[program] - limit_ / 8 - held_[scenes] - held_[models]);
  }
  /// A claim so small may have that eighth, and need not wait for larger ones. Unit: bytes.
  std::int64_t most_small() const { return limit_ / 32; }

  /// Books so many bytes, unless there are not so many. Never waits. noexcept: it is called while
  /// memory is allocated.
  bool take(Holder by, std::int64_t bytes) noexcept;
  /// Books what is there already, or, negative, that it is no more.
  void add(Holder by, std::int64_t bytes) noexcept;

  /// Who can let go of memory that is only kept to save time: is asked for so many bytes and says
  /// how many it gave. In this order.
  using GiveWay = std::function<std::int64_t(std::int64_t bytes)>;
  void on_shortage(GiveWay give_way);
  /// Asks them until so many bytes are free. Returns: whether they are.
  bool make_room(std::int64_t bytes);

  /// The most that one client's requests may have together, but for small ones, so that some is
  /// left for others; one request alone may have more.
  std::int64_t most_of_client() const { return most_of_one() / 2; }

  /// How often claims had to wait, and were refused.
  std::int64_t waits() const { return waits_; }
  std::int64_t refusals() const { return refusals_; }
  int waiting() const;

 private:
  friend class MemoryClaim;
  /// Client: what its requests have been granted together.
  struct Client {
    std::atomic<std::int64_t> granted = 0;
    int claims = 0;
  };
  /// Waiter: who needs more for its request.
  struct Waiter {
    std::int64_t bytes = 0, own = 0;  // what it needs, and has already
    Client* client = nullptr;         // null: of nobody's
  };
  using Waiters = std::list<Waiter>;
  Client* enter(const std::string& client);
  void leave(const std::string& client) noexcept;
  // Books it for a request, or waits until that is possible. Returns: whether it was in time.
  // Errors: Stopped.
  [[nodiscard]] bool wait_for(const Waiter& who, const std::stop_token& stop);
  bool take_fairly(Waiters::const_iterator who) noexcept;
  // Books it at once for a request that has so much, unless it is large and the eighth is at stake.
  bool take_more(std::int64_t own, std::int64_t bytes) noexcept;
  bool is_small(const Waiter& who) const { return who.own + who.bytes <= most_small(); }
  bool has_its_share(const Waiter& who) const noexcept;

  const std::int64_t limit_;
  std::atomic<std::int64_t> total_ = 0, waits_ = 0, refusals_ = 0;
  std::array<std::atomic<std::int64_t>, holders.size()> held_{};
  std::vector<GiveWay> give_way_;
  mutable std::mutex mutex_;
  std::condition_variable_any less_held_;
  Waiters waiting_;  // in the order of coming
  std::map<std::string, Client> clients_;
};

/// MemoryShare: what a store holds of the account, and may hold at most: an eighth of the account
/// it leaves to what is counted only when it is allocated. The store guards it.
class MemoryShare {
 public:
  /// Without an account only `most` bounds it.
  MemoryShare(std::int64_t most, MemoryAccount* account, MemoryAccount::Holder holder)
      : most_(most), account_(account), holder_(holder) {}
  ~MemoryShare() { book(0); }
  MemoryShare(const MemoryShare&) = delete;
  MemoryShare& operator=(const MemoryShare&) = delete;

  /// What the store may hold now: its own bound, and no more than the account leaves it.
  std::size_t most() const;
  /// That it holds so much from now on.
  void book(std::size_t bytes) noexcept;

 private:
  const std::int64_t most_;
  MemoryAccount* const account_;
  const MemoryAccount::Holder holder_;
  std::int64_t booked_ = 0;
};

/// MemoryClaim: what one request may take now. It grows by reserve(), before a step whose need is
/// known, and by charge(), where the allocator counts what no one could foresee; it ends with the
/// request. The threads that work for the request may charge at once.
class MemoryClaim {
 public:
  /// `client`: whose request it is; "": nobody's, who has no share.
  explicit MemoryClaim(MemoryAccount& account, const std::string& client = "")
      : account_(account), name_(client) {}
  ~MemoryClaim();
  MemoryClaim(const MemoryClaim&) = delete;
  MemoryClaim& operator=(const MemoryClaim&) = delete;

  /// Makes sure that so many bytes more than are in use now may be taken: at once, after caches
  /// have given way, or after a wait. `what` needs them, in words.
  /// Errors: HttpError: too-large where the account can never give them, busy where it has not for
  /// most_wait; Stopped.
  void reserve(std::int64_t bytes, std::string_view what, const std::stop_token& stop);
  /// Gives back what is not in use.
  void settle() noexcept;

  /// So many bytes have been allocated for the request. Returns: false where the account has none
  /// left, and then nothing is booked.
  bool charge(std::int64_t bytes) noexcept;
  void discharge(std::int64_t bytes) noexcept { used_ -= bytes; }
  /// Whether charge() has refused: then a failed allocation was the account's doing.
  bool was_refused() const { return was_refused_; }

  std::int64_t granted() const { return granted_; }
  std::int64_t used() const { return used_; }
  /// The most that was in use at once; 0 in programs whose allocator does not count.
  std::int64_t most_used() const { return most_used_; }
  double waited_ms() const { return waited_ms_; }

  /// The claim of the request that this thread works for, or null.
  static MemoryClaim* current();
  /// Why an allocation failed for which the account had no bytes: HttpError, too-large where no
  /// wait would help, else busy.
  HttpError refusal() const;

 private:
  void enter();
  // Counts to its client what the account has given, or, negative, gives it back.
  void grant(std::int64_t bytes) noexcept;

  MemoryAccount& account_;
  const std::string name_;
  MemoryAccount::Client* client_ = nullptr;  // whose share it counts to, once it reserves
  std::atomic<std::int64_t> granted_ = 0, used_ = 0, most_used_ = 0;
  std::atomic<bool> was_refused_ = false;
  double waited_ms_ = 0;
};

/// ForeseenMemory: what a step of a request will come to need though others come before it, as an
/// encoder which grows with its first frame: booked as in use until that step has taken it.
class ForeseenMemory {
 public:
  /// Errors: as MemoryClaim::reserve.
  ForeseenMemory(MemoryClaim& claim, std::int64_t bytes, std::string_view what,
                 const std::stop_token& stop);
  ~ForeseenMemory() { claim_.discharge(left_); }
  ForeseenMemory(const ForeseenMemory&) = delete;
  ForeseenMemory& operator=(const ForeseenMemory&) = delete;

  /// Does work of that step. What it has taken and keeps is foreseen no longer.
  void spend(const std::function<void()>& work);

 private:
  MemoryClaim& claim_;
  std::int64_t left_ = 0;
};

/// ClaimScope: while it lives, this thread and those that share its work charge the claim.
class ClaimScope {
 public:
  explicit ClaimScope(MemoryClaim* claim);
  ~ClaimScope();
  ClaimScope(const ClaimScope&) = delete;
  ClaimScope& operator=(const ClaimScope&) = delete;

 private:
  void* const outside_;
};

/// Reserves for the current request, if there is one. Errors: as MemoryClaim::reserve.
void reserve_memory(std::int64_t bytes, std::string_view what, const std::stop_token& stop);
/// Gives back what the current request has not in use.
void settle_memory();

/// What TIA_MEMORY_BYTES is by default: three quarters of what the machine, the control group and
/// the process limits (RLIMIT_AS) leave, at least 256 MiB.
std::int64_t usual_memory_bytes();

/// Where addresses are limited (RLIMIT_AS): how many of them the program has taken by now,
/// libraries and stacks, and may take `later`, that the limit does not leave besides so much
/// memory. Else 0. Unit: bytes.
std::int64_t addresses_beyond(std::int64_t memory_bytes, std::int64_t later);

}  // namespace tia::server
