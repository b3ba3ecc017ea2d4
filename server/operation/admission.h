// Who may read a long text and who may draw, and when: a bounded number at once, light work never
// behind heavy work, and no client before all others.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <mutex>
#include <stop_token>
#include <string>
#include <utility>

#include "server/http/error.h"
#include "server/operation/cost.h"

namespace tia::server {

/// Admission: gives out tickets. Any thread may call. Heavy work begins with at most half of them
/// (but one), and a quarter of the queue, so that a light picture need not wait for posters to end;
/// where both kinds wait, a light one goes first, unless no heavy one is at work: so heavy ones go
/// on, too. Among equals goes the client that has the fewest tickets, then who came first.
///
/// What has begun is never sent away for newcomers: how threads are shared is the pool's business
/// (core/parallel/turns.h). What could not end in time does not begin.
///
/// While others wait one client keeps no more than half: whose client holds none finds room beyond
/// the tickets where another holds more than half of them, or than its share with the newcomer; and
/// where the queue is full, the newest of the client that has most of it makes room for one that
/// has less (longest queue drop). Who waits for what others draw takes no place of who waits to
/// draw.
/// Source: McKenney, "Stochastic fairness queueing" (1990), section 3.
class Admission {
 public:
  /// Tests of rays beyond which work that was foreseen to be light is heavy: a quarter of a
  /// second's.
  static constexpr std::int64_t most_light_tests = 1 << 25;
  /// A text beyond it is long: some milliseconds to read. Unit: bytes.
  static constexpr std::size_t longest_short_text = 64 << 10;

  struct Options {
    int tickets = 8;
    int queue = 64;            ///< how many may wait in all
    int threads = 1;           ///< that all work shares
    double most_wait_s = 1e9;  ///< what work of one kind may take that is there already
  };

 private:
  enum : std::size_t { reading, light, heavy, kinds };
  /// Entrant: who waits, or is in; one entry of a list from coming to leaving.
  struct Entrant {
    Entrant(std::size_t of_kind, std::string whose, double takes)
        : client(std::move(whose)), seconds(takes), kind(of_kind) {}
    std::string client;
    double seconds;  // of threads, that the work is expected to take
    std::size_t kind;
    bool is_in = false, is_pushed_out = false;
    std::condition_variable_any changed{};          // one of the two above: wakes this one alone
    std::chrono::steady_clock::time_point since{};  // when it got in
  };
  using Entrants = std::list<Entrant>;
  using Places = std::map<std::string, int>;  // by client

 public:
  /// Ticket: the right to work, until it ends.
  class Ticket {
   public:
    Ticket(Ticket&& from) noexcept : from_(std::exchange(from.from_, nullptr)), who_(from.who_) {}
    ~Ticket() {
      if (from_ != nullptr) from_->leave(who_);
    }
    /// Tells what has been done so far. Light work that turns out heavy from then on takes no light
    /// one's place. Any thread may call.
    void has_done(std::int64_t rays, std::int64_t tests) {
      if (rays > Cost::most_light_rays || tests > most_light_tests) turn_heavy();
    }
    /// Light work turns out heavy for another reason. Any thread may call.
    void turn_heavy() { from_->turn_heavy(who_); }
    /// Whose it is: its work counts to that client.
    const std::string& client() const { return who_->client; }

   private:
    friend Admission;
    Ticket() = default;
    Ticket(Admission* from, Entrants::iterator who) : from_(from), who_(who) {}
    Admission* from_ = nullptr;  // null: of work that needs none
    Entrants::iterator who_{};
  };

  /// QueuePlace: one in the queue, of who waits for what others do.
  class QueuePlace {
   public:
    QueuePlace(QueuePlace&& from) noexcept
        : from_(std::exchange(from.from_, nullptr)), place_(from.place_) {}
    ~QueuePlace() {
      if (from_ != nullptr) from_->leave_place(place_);
    }

   private:
    friend Admission;
    QueuePlace(Admission* from, Places::iterator place) : from_(from), place_(place) {}
    Admission* from_;
    Places::iterator place_;
  };

  /// Waiting: a place in the queue while somebody is in it, that may become another client's. Any
  /// thread may call.
  class Waiting {
   public:
    /// That this client waits for the same: the place counts to the one that has less of the queue
    /// and of the tickets.
    void also_for(const std::string& client) {
      if (Admission* from = from_.load()) from->share(*this, client);
    }

   private:
    friend Admission;
    std::atomic<Admission*> from_ = nullptr;  // null: nobody has come yet
    Entrants::iterator who_{};
    bool is_waiting_ = false;
  };

  explicit Admission(const Options& options);

  /// Waits for a ticket to read a text of so many bytes: long ones a few at a time.
  /// Errors: as enter().
  [[nodiscard]] Ticket read(std::size_t bytes, const std::string& client,
                            const std::stop_token& stop);
  /// Waits for a ticket for work of that cost. Errors: Stopped; HttpError (busy) where all places
  /// to wait for its kind are taken, or what is there already takes too long.
  [[nodiscard]] Ticket enter(const Cost& cost, const std::string& client,
                             const std::stop_token& stop, Waiting* place = nullptr);
  /// A place to wait in without a ticket: as many as the queue has, of which a client may have
  /// half. Errors: HttpError (busy).
  [[nodiscard]] QueuePlace wait_for_others(const std::string& client);

  int at_work() const;
  int waiting() const;
  /// When one who finds all places taken may ask again, by how long work took lately. Unit: s.
  int retry_after() const;

 private:
  struct Kind {
    int most = 0, most_waiting = 0;
    double usual_s = 0;                  // how long a ticket is held, a moving mean
    Entrants waiting = {}, inside = {};  // in the order of coming

    int at_work() const { return static_cast<int>(inside.size()); }
    int held_by(const std::string& client) const;
    int clients_inside() const;
  };
  Ticket enter_as(std::size_t kind, const std::string& client, double seconds,
                  const std::stop_token& stop, Waiting* place = nullptr);
  void share(const Waiting& place, const std::string& client);
  std::ptrdiff_t places_of(const std::string& client) const;
  void check_time(const Kind& kind, const Entrant& who) const;
  void find_place(const Entrant& who);
  bool push_out(std::size_t kind, const std::string& client);
  void admit();
  bool admit_next(Kind& kind);
  bool may_enter(const Entrant& who) const;
  bool has_room(const Entrant& who) const;
  int light_places_taken() const;
  void turn_heavy(Entrants::iterator who);
  void leave(Entrants::iterator who);
  void leave_place(Places::iterator place);
  int waiting_to_enter() const;
  int wait_s() const;
  HttpError busy(const char* why) const;

  const int queue_, threads_;
  const double most_wait_s_;
  mutable std::mutex mutex_;
  std::array<Kind, kinds> kinds_;
  Places places_;      // of who wait for what others do
  int in_places_ = 0;  // how many they are
};

}  // namespace tia::server
