#include "core/parallel/turns.h"

#include <algorithm>
#include <limits>
#include <new>
#include <ranges>
#include <utility>

namespace tia {
namespace {

// Prepares for one more among others, which `each` goes through: bounds what they are owed.
// Returns: the least that one of them has had, or `level` without any or where that is more.
template <class Each>
Nanoseconds settled_level(const Each& each, Nanoseconds level, Nanoseconds now) {
  constexpr Nanoseconds none = std::numeric_limits<Nanoseconds>::min();
  Nanoseconds most = none;
  each([&](ServiceTime& service) { most = std::max(most, service.at(now)); });
  if (most == none) return level;
  Nanoseconds least = most;
  each([&](ServiceTime& service) {
    service.raise_to(most - Turns::arrears, now);
    least = std::min(least, service.at(now));
  });
  return std::max(level, least);
}

// The oldest of a client's long jobs that can use a hand; null without one.
const Turn* oldest_long(const ClientJobs& client) {
  const Turn* oldest = nullptr;
  for (const Turn* job : client.jobs)
    if (job->flow.is_long && job->wants_hand() &&
        (oldest == nullptr || job->flow.order < oldest->flow.order))
      oldest = job;
  return oldest;
}

// Whether it must let an older long job of its client go on first.
bool is_parked(const Turn& job) {
  if (!job.flow.is_long) return false;
  const Turn* oldest = oldest_long(*job.client);
  return oldest != nullptr && oldest->flow.order < job.flow.order;
}

// By how much more service one has had than the other, where it counts: among clients first.
Nanoseconds ahead(const Turn& one, const Turn& other, Nanoseconds now) {
  if (one.client != other.client)
    return one.client->service.at(now) - other.client->service.at(now);
  return one.service.at(now) - other.service.at(now);
}

// How many times a thread's time counts.
int weight(const ClientJobs& client) { return client.is_background ? Turns::background_cost : 1; }

void add_once(std::vector<std::uint64_t>& numbers, std::uint64_t number) {
  if (std::ranges::find(numbers, number) == numbers.end()) numbers.push_back(number);
}

}  // namespace

// Calls action(job) for every job that can use one more hand and is not parked.
template <class Action>
void Turns::for_each_candidate(const Action& action) const {
  for (const ClientJobs& client : clients_) {
    const Turn* oldest = oldest_long(client);
    for (Turn* job : client.jobs)
      if (job->wants_hand() && (!job->flow.is_long || job == oldest)) action(*job);
  }
}

ClientJobs* Turns::find(std::uint64_t client) {
  const auto known = std::ranges::find(clients_, client, &ClientJobs::number);
  return known != clients_.end() ? &*known : nullptr;
}

ClientJobs& Turns::client_of(std::uint64_t number, bool is_background, Nanoseconds now) {
  ClientJobs* const known = find(number);
  if (known != nullptr && !known->jobs.empty()) return *known;
  const auto each = [this](const auto& action) {
    for (ClientJobs& client : clients_)
      if (!client.jobs.empty()) action(client.service);
  };
  level_ = settled_level(each, level_, now);
  if (known != nullptr) {  // it has been away, and owes no more than it can be owed
    const Nanoseconds had = known->service.at(now);
    known->service.before += std::clamp(had, level_, level_ + arrears) - had;
    return *known;
  }
  ClientJobs& made = clients_.emplace_back(ClientJobs{number, is_background});
  made.service.before = is_background ? level_ : level_ - credit;
  return made;
}

void Turns::enter(Turn& job, Nanoseconds now) {
  choose_client(job.flow, now);
  ClientJobs& client = client_of(job.flow.client, job.flow.is_background, now);
  client.jobs.reserve(client.jobs.size() + 1);
  join(job, client, now);
}

// Domain: there is room for it. It allocates nothing.
void Turns::join(Turn& job, ClientJobs& client, Nanoseconds now) {
  const auto each = [&client](const auto& action) {
    for (Turn* other : client.jobs)
      if (!is_parked(*other)) action(other->service);
  };
  client.level = settled_level(each, client.level, now);
  Flow& flow = job.flow;
  if (flow.order == 0) {
    flow.order = ++entered_;
    flow.place = client.level - credit;
    flow.credit_end = client.level;
  }
  job.service.before = std::max(flow.place, client.level - credit) - job.service.awake * now;
  const int awake = job.service.awake * weight(client);
  client.service.before -= awake * now;
  client.service.awake += awake;
  client.jobs.push_back(&job);
  job.client = &client;
}

// It may have hands at work, which it takes along.
void Turns::leave(Turn& job, Nanoseconds now) {
  ClientJobs& client = *job.client;
  job.flow.place = job.service.at(now);
  const int awake = job.service.awake * weight(client);
  client.service.before += awake * now;
  client.service.awake -= awake;
  client.jobs.erase(std::ranges::find(client.jobs, &job));
  job.client = nullptr;
  if (client.jobs.empty() && !client.is_background)
    clients_.remove_if([&](const ClientJobs& each) { return &each == &client; });
}

// Whether it waits for an older long job where it is and would not there, or has had more there.
bool Turns::would_be_sooner(const Flow& flow, std::uint64_t client, Nanoseconds now) {
  const ClientJobs *own = find(flow.client), *theirs = find(client);
  if (own == nullptr || (flow.is_long && theirs != nullptr && oldest_long(*theirs) != nullptr))
    return false;
  const auto waits = [&](const Turn* job) { return &job->flow == &flow && is_parked(*job); };
  return std::ranges::any_of(own->jobs, waits) ||
         own->service.at(now) > (theirs != nullptr ? theirs->service.at(now) : level_) + slice;
}

// Domain: would_be_sooner().
void Turns::move(Flow& flow, std::uint64_t client, Nanoseconds now) {
  std::vector<Turn*> jobs;
  for (Turn* job : find(flow.client)->jobs)
    if (&job->flow == &flow) jobs.push_back(job);
  if (!jobs.empty()) {
    ClientJobs& theirs = client_of(client, false, now);
    theirs.jobs.reserve(theirs.jobs.size() + jobs.size());
  }
  for (Turn* job : jobs) leave(*job, now);
  flow.client = client;
  flow.order = 0;
  for (Turn* job : jobs) join(*job, *find(client), now);
}

// It may come back to whose it was.
void Turns::choose_client(Flow& flow, Nanoseconds now) {
  if (flow.others.empty()) return;
  add_once(flow.others, flow.client);
  for (const std::uint64_t client : flow.others)
    if (client != flow.client && would_be_sooner(flow, client, now)) move(flow, client, now);
}

void Turns::also_for(Flow& flow, std::uint64_t client, Nanoseconds now) {
  add_once(flow.others, client);
  choose_client(flow, now);
}

void Turns::pause(Turn& job, Nanoseconds now) {
  job.next = job.count;
  job.flow.place = job.service.at(now);
}

void Turns::resume(Turn& job) {
  job.next = 0;
  job.service.before = job.flow.place;
}

// How many hands beyond the threads there may be for a job to have its first. The second is for a
// client without any, whom another's young ones must not keep out.
int Turns::extra_hands(const Turn& job, Nanoseconds now) {
  if (job.hands > 0 || !job.is_young(now)) return 0;
  const auto has_none = [](const Turn* each) { return each->hands == 0; };
  return std::ranges::all_of(job.client->jobs, has_none) ? 2 : 1;
}

// Whether no job at work has had more, by a slice. It may be one that does not look for others.
bool Turns::has_had_most(const Turn& job, Nanoseconds now) const {
  for (const ClientJobs& client : clients_)
    for (const Turn* each : client.jobs)
      if (each != &job && each->service.awake > 0 && ahead(*each, job, now) > slice) return false;
  return true;
}

Turn* Turns::next(Nanoseconds now, const Can& can) const {
  bool old_at_work = false;
  for (const ClientJobs& client : clients_)
    for (const Turn* job : client.jobs)
      old_at_work = old_at_work || (job->service.awake > 0 && !job->is_young(now));
  Turn* next = nullptr;
  for_each_candidate([&](Turn& job) {
    if (hands_ >= threads_ + (old_at_work ? extra_hands(job, now) : 0)) return;
    if ((next == nullptr || ahead(job, *next, now) < 0) && can(job)) next = &job;
  });
  return next;
}

bool Turns::stays(const Turn& job, Nanoseconds now) const {
  if (is_parked(job)) return false;
  if (hands_ > threads_ && !job.is_young(now) && has_had_most(job, now)) return false;
  bool stays = true;
  for_each_candidate([&](const Turn& other) {
    if (&other != &job && ahead(job, other, now) > slice) stays = false;
  });
  return stays;
}

// One that was parked has waited, but not been owed anything meanwhile.
void Turns::call(Turn& job, Nanoseconds now) {
  if (std::exchange(job.rested, false)) job.service.raise_to(job.client->level, now);
  ++hands_;
  ++job.hands;
}

void Turns::dismiss(Turn& job) {
  --hands_;
  --job.hands;
}

void Turns::begin(Turn& job, Nanoseconds now) {
  job.service.begin(now);
  job.client->service.begin(now, weight(*job.client));
}

void Turns::end(Turn& job, Nanoseconds now) {
  job.service.end(now);
  job.client->service.end(now, weight(*job.client));
}

void Turns::spend(Turn& job, Nanoseconds time, Nanoseconds now) {
  ClientJobs& client = *job.client;
  const auto parked =
      std::ranges::count_if(client.jobs, [](Turn* each) { return is_parked(*each); });
  const auto present = static_cast<Nanoseconds>(client.jobs.size()) - parked;
  client.level += time / (2 * std::max<Nanoseconds>(present, 1));
  const auto at_hand =
      std::ranges::count_if(clients_, [](const ClientJobs& each) { return !each.jobs.empty(); });
  level_ += time / (4 * static_cast<Nanoseconds>(at_hand));
  job.flow.attained += time;
  if (job.flow.is_long || job.flow.attained < long_service) return;
  job.flow.is_long = true;
  if (job.flow.became_long) job.flow.became_long();
  try {
    choose_client(job.flow, now);
  } catch (const std::bad_alloc&) {  // then it stays whose it is
  }
}

}  // namespace tia
