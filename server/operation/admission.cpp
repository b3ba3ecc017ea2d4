#include "server/operation/admission.h"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <string>

#include "core/parallel/stopped.h"

namespace tia::server {

int Admission::Kind::held_by(const std::string& client) const {
  return static_cast<int>(std::ranges::count(inside, client, &Entrant::client));
}

int Admission::Kind::clients_inside() const {
  int clients = 0;
  for (auto each = inside.begin(); each != inside.end(); ++each)
    clients += std::none_of(inside.begin(), each,
                            [&](const Entrant& known) { return known.client == each->client; });
  return clients;
}

Admission::Admission(const Options& o)
    : queue_(o.queue),
      threads_(o.threads),
      most_wait_s_(o.most_wait_s),
      kinds_{Kind{std::max(1, o.tickets / 4), o.queue / 4, 0.1}, Kind{o.tickets, o.queue, 0.1},
             Kind{std::max(1, o.tickets / 2), o.queue / 4, 1}} {}

Admission::Ticket Admission::read(std::size_t bytes, const std::string& client,
                                  const std::stop_token& stop) {
  if (bytes <= longest_short_text) return {};
  return enter_as(reading, client, 0, stop);
}

Admission::Ticket Admission::enter(const Cost& cost, const std::string& client,
                                   const std::stop_token& stop, Waiting* place) {
  return enter_as(cost.is_heavy() ? heavy : light, client, cost.seconds, stop, place);
}

Admission::Ticket Admission::enter_as(std::size_t kind, const std::string& client, double seconds,
                                      const std::stop_token& stop, Waiting* place) {
  Entrants made;
  const auto who = made.emplace(made.end(), kind, client, seconds);
  Kind& mine = kinds_[kind];
  std::unique_lock lock(mutex_);
  check_time(mine, *who);
  mine.waiting.splice(mine.waiting.end(), made);
  const auto wait_ends = [&] {
    if (place != nullptr) place->is_waiting_ = false;
  };
  const auto give_up = [&] {
    wait_ends();
    made.splice(made.end(), mine.waiting, who);
    admit();
  };
  if (place != nullptr) {
    place->who_ = who;
    place->is_waiting_ = true;
    place->from_ = this;
  }
  admit();
  try {
    if (!who->is_in) find_place(*who);
  } catch (...) {
    give_up();
    throw;
  }
  who->changed.wait(lock, stop, [&] { return who->is_in || who->is_pushed_out; });
  if (!who->is_in) {
    give_up();
    if (who->is_pushed_out)
      throw busy("the queue is full, and others have less of it (option TIA_QUEUE)");
    throw Stopped();
  }
  wait_ends();
  lock.unlock();
  Ticket ticket(this, who);
  end_if_asked(stop);
  return ticket;
}

// What has no time left once those before it are done would be begun for nothing: all of its own
// client's, and of each other's as much as that, for they share.
void Admission::check_time(const Kind& kind, const Entrant& who) const {
  const bool alone = kind.inside.empty() && kind.waiting.empty();
  std::map<std::string, double> seconds;
  for (const Entrants* those : {&kind.inside, &kind.waiting})
    for (const Entrant& each : *those) seconds[each.client] += each.seconds;
  const double own = seconds[who.client] += who.seconds;
  double before = 0;
  for (const auto& [client, theirs] : seconds) before += std::min(own, theirs);
  if (!alone && before / threads_ > most_wait_s_)
    throw busy("what is there already would take too long (option TIA_DEADLINE_MS)");
}

// Sees to it that there is room for one more in the queue, who is in it already.
// Errors: HttpError (busy).
void Admission::find_place(const Entrant& who) {
  static constexpr const char* full_queue[] = {
      "a quarter of the queue is full of long texts (option TIA_QUEUE)",
      "the queue is full (option TIA_QUEUE)",
      "a quarter of the queue is full of posters (option TIA_QUEUE)"};
  const Kind& mine = kinds_[who.kind];
  const bool own_full = static_cast<int>(mine.waiting.size()) > mine.most_waiting;
  if (!own_full && waiting_to_enter() <= queue_) return;
  if (!push_out(own_full ? who.kind : kinds, who.client)) throw busy(full_queue[who.kind]);
}

// Of that kind, or of any, sends the newest of the client away that has most of the queue, if that
// is more than this one has with the new one. Returns: whether there was such a one.
bool Admission::push_out(std::size_t kind, const std::string& client) {
  const std::ptrdiff_t own = places_of(client);
  std::ptrdiff_t most = own;
  Entrant* newest = nullptr;
  for (std::size_t i = 0; i < kinds; ++i) {
    if (kind != kinds && kind != i) continue;
    for (Entrant& who : kinds_[i].waiting) {
      if (who.is_pushed_out) continue;
      const std::ptrdiff_t places = places_of(who.client);
      if (places <= own || places < most) continue;
      most = places;
      newest = &who;
    }
  }
  if (newest == nullptr) return false;
  newest->is_pushed_out = true;
  newest->changed.notify_one();
  return true;
}

// How many of those that wait are that client's.
std::ptrdiff_t Admission::places_of(const std::string& client) const {
  std::ptrdiff_t places = 0;
  for (const Kind& each : kinds_)
    places += std::ranges::count_if(each.waiting, [&](const Entrant& who) {
      return who.client == client && !who.is_pushed_out;
    });
  return places;
}

void Admission::share(const Waiting& place, const std::string& client) {
  const std::lock_guard lock(mutex_);
  if (!place.is_waiting_ || place.who_->is_in || place.who_->is_pushed_out) return;
  const auto has = [&](const std::string& whose) {
    std::ptrdiff_t all = places_of(whose);
    for (const Kind& each : kinds_) all += each.held_by(whose);
    return all;
  };
  if (has(client) + 1 >= has(place.who_->client)) return;
  place.who_->client = client;
  admit();
}

// ---- whose turn it is -----------------------------------------------------------------------

// Lets in all who may enter now. It allocates nothing: tickets end with it.
void Admission::admit() {
  bool again = true;
  while (again) {
    again = false;
    for (Kind& kind : kinds_) again = admit_next(kind) || again;
  }
}

// The next of a kind: of the client that has the fewest tickets. Returns: whether one got in.
bool Admission::admit_next(Kind& kind) {
  auto next = kind.waiting.end();
  int fewest = 0;
  for (auto who = kind.waiting.begin(); who != kind.waiting.end(); ++who) {
    const int held = kind.held_by(who->client);
    if (who->is_pushed_out || (next != kind.waiting.end() && held >= fewest)) continue;
    next = who;
    fewest = held;
  }
  if (next == kind.waiting.end() || !may_enter(*next)) return false;
  next->is_in = true;
  next->since = std::chrono::steady_clock::now();
  kind.inside.splice(kind.inside.end(), kind.waiting, next);
  next->changed.notify_one();
  return true;
}

// Heavy work beyond its share has begun as light and takes nobody's place.
int Admission::light_places_taken() const {
  return kinds_[light].at_work() + std::min(kinds_[heavy].at_work(), kinds_[heavy].most);
}

bool Admission::has_room(const Entrant& who) const {
  const Kind& kind = kinds_[who.kind];
  const bool is_full = kind.at_work() >= kind.most ||
                       (who.kind != reading && light_places_taken() >= kinds_[light].most);
  if (!is_full) return true;
  // Clients count here, not their requests: of one client any number may have turned heavy.
  if (kind.held_by(who.client) > 0 || kind.clients_inside() >= 2 * kind.most) return false;
  const int fair = std::max(1, kind.most / (kind.clients_inside() + 1));
  return std::ranges::any_of(kind.inside, [&](const Entrant& each) {
    const int held = kind.held_by(each.client);
    return held > fair || 2 * held > kind.most;
  });
}

bool Admission::may_enter(const Entrant& who) const {
  if (!has_room(who)) return false;
  if (who.kind == reading || kinds_[who.kind == light ? heavy : light].waiting.empty()) return true;
  const bool heavy_first = kinds_[heavy].inside.empty();
  return (who.kind == heavy) == heavy_first;
}

void Admission::turn_heavy(Entrants::iterator who) {
  const std::lock_guard lock(mutex_);
  if (who->kind != light) return;
  Kind &from = kinds_[light], &to = kinds_[heavy];
  who->seconds = std::max(who->seconds, 2 * Cost::most_light_seconds);
  who->kind = heavy;
  to.inside.splice(to.inside.end(), from.inside, who);
  admit();
}

void Admission::leave(Entrants::iterator who) {
  const std::lock_guard lock(mutex_);
  Kind& kind = kinds_[who->kind];
  const std::chrono::duration<double> held = std::chrono::steady_clock::now() - who->since;
  kind.usual_s += (held.count() - kind.usual_s) / 16;
  kind.inside.erase(who);
  admit();
}

// ---- who wait for others --------------------------------------------------------------------

Admission::QueuePlace Admission::wait_for_others(const std::string& client) {
  const std::lock_guard lock(mutex_);
  const int most = std::max(queue_, kinds_[light].most);
  const auto own = places_.find(client);
  const bool has_half = !client.empty() && own != places_.end() && 2 * own->second >= most;
  if (in_places_ >= most || has_half) throw busy("the queue is full (option TIA_QUEUE)");
  const auto place = own != places_.end() ? own : places_.emplace(client, 0).first;
  ++place->second;
  ++in_places_;
  return {this, place};
}

void Admission::leave_place(Places::iterator place) {
  const std::lock_guard lock(mutex_);
  --in_places_;
  if (--place->second == 0) places_.erase(place);
}

// ---- numbers --------------------------------------------------------------------------------

int Admission::at_work() const {
  const std::lock_guard lock(mutex_);
  return kinds_[light].at_work() + kinds_[heavy].at_work();
}

int Admission::waiting() const {
  const std::lock_guard lock(mutex_);
  return waiting_to_enter() + in_places_;
}

int Admission::waiting_to_enter() const {
  std::size_t all = 0;
  for (const Kind& kind : kinds_) all += kind.waiting.size();
  return static_cast<int>(all);
}

int Admission::retry_after() const {
  const std::lock_guard lock(mutex_);
  return wait_s();
}

int Admission::wait_s() const {
  double wait = 0;
  for (const Kind& kind : kinds_) {
    const auto ahead = static_cast<int>(kind.waiting.size()) + kind.at_work();
    wait += kind.usual_s * ahead / kind.most;
  }
  return static_cast<int>(std::clamp(std::ceil(wait), 1.0, 60.0));
}

HttpError Admission::busy(const char* why) const {
  return {"busy", why, {{"Retry-After", std::to_string(wait_s())}}};
}

}  // namespace tia::server
