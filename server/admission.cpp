#include "server/admission.h"

#include <algorithm>
#include <cmath>

#include "core/render/pool.h"

namespace tia::server {

Admission::Admission(int tickets) : tickets_(tickets) {
  kinds_[light].most = tickets;
  kinds_[heavy].most = std::max(1, tickets / 2);
}

Admission::Ticket Admission::enter(double rays, const std::stop_token& stop) {
  const std::size_t kind = rays > most_light_rays ? heavy : light;
  Kind& mine = kinds_[kind];
  std::unique_lock lock(mutex_);
  const auto place = mine.waiting.insert(mine.waiting.end(), 0);
  const bool entered =
      left_.wait(lock, stop, [&] { return place == mine.waiting.begin() && may_enter(kind); });
  mine.waiting.erase(place);
  left_.notify_all();  // the next one's turn
  if (!entered || stop.stop_requested()) throw Stopped();
  ++mine.at_work;
  return {*this, kind};
}

bool Admission::may_enter(std::size_t kind) const {
  const Kind &mine = kinds_[kind], &other = kinds_[1 - kind];
  if (all_at_work() == tickets_ || mine.at_work == mine.most) return false;
  if (other.waiting.empty()) return true;
  const bool heavy_first = kinds_[heavy].at_work == 0;
  return (kind == heavy) == heavy_first;
}

void Admission::leave(const Ticket& ticket) {
  const std::chrono::duration<double> held = std::chrono::steady_clock::now() - ticket.since_;
  const std::lock_guard lock(mutex_);
  --kinds_[ticket.kind_].at_work;
  usual_s_ += (held.count() - usual_s_) / 16;
  left_.notify_all();
}

int Admission::at_work() const {
  const std::lock_guard lock(mutex_);
  return all_at_work();
}

int Admission::waiting() const {
  const std::lock_guard lock(mutex_);
  return static_cast<int>(kinds_[light].waiting.size() + kinds_[heavy].waiting.size());
}

int Admission::retry_after() const {
  const std::lock_guard lock(mutex_);
  const auto ahead = kinds_[light].waiting.size() + kinds_[heavy].waiting.size() + 1;
  const double wait_s = usual_s_ * static_cast<double>(ahead) / tickets_;
  return static_cast<int>(std::clamp(std::ceil(wait_s), 1.0, 60.0));
}

}  // namespace tia::server
