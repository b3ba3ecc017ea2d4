#include "core/render/turns.h"

#include <algorithm>

namespace tia {

void Turns::enter(Turn& job, Nanoseconds now) {
  if (!jobs_.empty()) {
    const auto less = [&](const Turn* a, const Turn* b) {
      return a->service(now) < b->service(now);
    };
    const Nanoseconds most = (*std::max_element(jobs_.begin(), jobs_.end(), less))->service(now);
    for (Turn* each : jobs_)
      each->before += std::max<Nanoseconds>(most - arrears - each->service(now), 0);
    const Nanoseconds least = (*std::min_element(jobs_.begin(), jobs_.end(), less))->service(now);
    level_ = std::max(level_, least);
  }
  job.before = level_ - credit;
  job.young = level_;
  jobs_.push_back(&job);
}

void Turns::leave(const Turn& job) { jobs_.erase(std::find(jobs_.begin(), jobs_.end(), &job)); }

Turn* Turns::next(Nanoseconds now) const {
  const bool old_at_work = std::any_of(jobs_.begin(), jobs_.end(), [&](const Turn* job) {
    return job->awake > 0 && !job->is_young(now);
  });
  Turn* next = nullptr;
  for (Turn* job : jobs_) {
    const bool extra = old_at_work && job->hands == 0 && job->is_young(now);
    if (!job->wants_hand() || hands_ >= threads_ + (extra ? 1 : 0)) continue;
    if (next == nullptr || job->service(now) < next->service(now)) next = job;
  }
  return next;
}

bool Turns::stays(const Turn& job, Nanoseconds now) const {
  if (!job.has_tasks()) return false;
  if (hands_ > threads_ && !job.is_young(now)) return false;
  return std::none_of(jobs_.begin(), jobs_.end(), [&](const Turn* other) {
    return other->wants_hand() && other->service(now) + slice < job.service(now);
  });
}

void Turns::call(Turn& job) {
  ++hands_;
  ++job.hands;
}

void Turns::dismiss(Turn& job) {
  --hands_;
  --job.hands;
}

void Turns::begin(Turn& job, Nanoseconds now) {
  ++job.awake;
  job.before -= now;
}

void Turns::end(Turn& job, Nanoseconds now) {
  --job.awake;
  job.before += now;
}

void Turns::spend(Nanoseconds time) {
  level_ += time / (2 * static_cast<Nanoseconds>(jobs_.size()));
}

}  // namespace tia
