#include "server/admission.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/render/pool.h"

namespace tia::server {

Admission::Admission(int tickets, int queue)
    : kinds_{Kind{std::max(1, tickets / 4), queue / 4, 0.1}, Kind{tickets, queue, 0.1},
             Kind{std::max(1, tickets / 2), queue / 4, 1}} {}

Admission::Ticket Admission::read(std::size_t bytes, const std::stop_token& stop) {
  if (bytes <= longest_short_text) return {nullptr, reading};
  return enter_as(reading, stop);
}

Admission::Ticket Admission::enter(double rays, const std::stop_token& stop) {
  return enter_as(rays > most_light_rays ? heavy : light, stop);
}

Admission::Ticket Admission::enter_as(std::size_t kind, const std::stop_token& stop) {
  static constexpr const char* full_queue[] = {
      "a quarter of the queue is full of long texts (option TIA_QUEUE)",
      "the queue is full (option TIA_QUEUE)",
      "a quarter of the queue is full of posters (option TIA_QUEUE)"};
  Kind& mine = kinds_[kind];
  std::unique_lock lock(mutex_);
  const auto place = mine.waiting.insert(mine.waiting.end(), 0);
  const auto its_turn = [&] { return place == mine.waiting.begin() && may_enter(kind); };
  // Not by who waits alone: of those some may enter already, and have not woken up yet.
  const bool full =
      mine.at_work + static_cast<int>(mine.waiting.size()) > mine.most + mine.most_waiting;
  const bool entered = !full && left_.wait(lock, stop, its_turn);
  mine.waiting.erase(place);
  left_.notify_all();  // the next one's turn
  if (full) throw busy(full_queue[kind]);
  if (!entered || stop.stop_requested()) throw Stopped();
  ++mine.at_work;
  return {this, kind};
}

// Heavy work beyond its share has begun as light and takes nobody's place.
int Admission::light_places_taken() const {
  return kinds_[light].at_work + std::min(kinds_[heavy].at_work, kinds_[heavy].most);
}

bool Admission::may_enter(std::size_t kind) const {
  const Kind& mine = kinds_[kind];
  if (mine.at_work >= mine.most) return false;
  if (kind == reading) return true;
  if (light_places_taken() >= kinds_[light].most) return false;
  if (kinds_[kind == light ? heavy : light].waiting.empty()) return true;
  const bool heavy_first = kinds_[heavy].at_work == 0;
  return (kind == heavy) == heavy_first;
}

void Admission::turn_heavy(Ticket& ticket) {
  const std::lock_guard lock(mutex_);
  if (ticket.kind_ != light) return;
  if (kinds_[heavy].at_work >= kinds_[light].most) {
    if (kinds_[light].waiting.empty()) return;
    throw busy(
        "the picture turns out to be a poster, of which many are drawn (option TIA_RENDERS)");
  }
  --kinds_[light].at_work;
  ++kinds_[heavy].at_work;
  ticket.kind_ = heavy;
  left_.notify_all();
}

void Admission::leave(const Ticket& ticket) {
  const std::chrono::duration<double> held = std::chrono::steady_clock::now() - ticket.since_;
  const std::lock_guard lock(mutex_);
  Kind& kind = kinds_[ticket.kind_];
  --kind.at_work;
  kind.usual_s += (held.count() - kind.usual_s) / 16;
  left_.notify_all();
}

int Admission::at_work() const {
  const std::lock_guard lock(mutex_);
  return kinds_[light].at_work + kinds_[heavy].at_work;
}

int Admission::waiting() const {
  const std::lock_guard lock(mutex_);
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
    const auto ahead = static_cast<int>(kind.waiting.size()) + kind.at_work;
    wait += kind.usual_s * ahead / kind.most;
  }
  return static_cast<int>(std::clamp(std::ceil(wait), 1.0, 60.0));
}

HttpError Admission::busy(const char* why) const {
  return {"busy", why, {{"Retry-After", std::to_string(wait_s())}}};
}

}  // namespace tia::server
