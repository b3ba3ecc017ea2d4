#include "core/render/pool.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>

namespace tia {
namespace {

thread_local bool inside_task = false;

void in_turn(int count, const std::stop_token& stop, const std::function<void(int)>& task) {
  for (int i = 0; i < count; ++i) {
    end_if_asked(stop);
    task(i);
  }
  end_if_asked(stop);
}

}  // namespace

/// Hand: a thread that can work: one of the pool's own, or a caller, which has but its own job.
struct Pool::Hand {
  Job* job = nullptr;  // where it works, or is called to while it sleeps
  std::condition_variable_any called;
};

struct Pool::Job {
  const int count, most_hands;
  const std::stop_token& stop;
  const std::function<void(int)>& task;
  std::atomic<int> next = 0;
  int hands = 0;           // guarded by the pool's mutex, as is all below
  int awake = 0;           // of them
  Nanoseconds before = 0;  // the service that those found, less the times at which they came
  Nanoseconds young = 0;   // the service up to which it is within its credit
  std::exception_ptr failure = nullptr;
  Hand caller{};

  bool has_tasks() const { return next.load(std::memory_order_relaxed) < count; }
  bool wants_hand() const { return has_tasks() && hands < most_hands; }
  bool is_over() const { return hands == 0 && !has_tasks(); }
  Nanoseconds service(Nanoseconds now) const { return before + awake * now; }
  bool is_young(Nanoseconds now) const { return service(now) < young; }

  // Takes tasks until that time. Returns: what a task threw.
  std::exception_ptr run(const Clock& clock, Nanoseconds end) {
    inside_task = true;
    std::exception_ptr thrown = nullptr;
    try {
      run_tasks(clock, end);
    } catch (...) {
      next = count;
      thrown = std::current_exception();
    }
    inside_task = false;
    return thrown;
  }
  void run_tasks(const Clock& clock, Nanoseconds end) {
    do {
      if (stop.stop_requested()) next = count;
      const int i = next.fetch_add(1, std::memory_order_relaxed);
      if (i >= count) return;
      task(i);
    } while (clock() < end);
  }
};

Pool::Nanoseconds Pool::steady_clock() {
  using namespace std::chrono;
  return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

Pool::Pool(int threads, Clock clock) : threads_(threads), clock_(std::move(clock)) {
  idle_.reserve(static_cast<std::size_t>(threads));
  for (int i = 1; i < threads; ++i)
    workers_.emplace_back([this](const std::stop_token& ending) { serve(ending); });
}

Pool::~Pool() {
  for (std::jthread& worker : workers_) worker.request_stop();
}

void Pool::for_each(int count, int max_threads, const std::stop_token& stop,
                    const std::function<void(int)>& task) {
  if (inside_task) return in_turn(count, stop, task);
  Job job{.count = count, .most_hands = std::min(max_threads, count), .stop = stop, .task = task};
  Hand& hand = job.caller;
  std::unique_lock lock(mutex_);
  enter(job);
  call_hands();
  const auto has_news = [&] { return hand.job != nullptr || job.is_over(); };
  while (hand.called.wait(lock, stop, has_news) && !job.is_over()) {
    work(hand, lock);
    call_hands();
  }
  job.next = count;  // it may have been stopped while nobody was at work
  dismiss_idle(job);
  hand.called.wait(lock, [&] { return job.hands == 0; });
  jobs_.erase(std::find(jobs_.begin(), jobs_.end(), &job));
  lock.unlock();
  if (job.failure) std::rethrow_exception(job.failure);
  end_if_asked(stop);
}

void Pool::serve(const std::stop_token& ending) {
  Hand hand;
  std::unique_lock lock(mutex_);
  for (;;) {
    if (Job* job = next_job(clock_())) {
      seat(hand, *job);
    } else {
      idle_.push_back(&hand);
      if (!hand.called.wait(lock, ending, [&] { return hand.job != nullptr; })) return;
      idle_.erase(std::find(idle_.begin(), idle_.end(), &hand));
    }
    work(hand, lock);
  }
}

// From a hand's coming to its leaving. The mutex is free while tasks run.
void Pool::work(Hand& hand, std::unique_lock<std::mutex>& lock) {
  Job& job = *hand.job;
  Nanoseconds now = clock_();
  ++job.awake;
  job.before -= now;
  do {
    const Nanoseconds since = now;
    lock.unlock();
    const std::exception_ptr thrown = job.run(clock_, since + look);
    lock.lock();
    if (thrown && !job.failure) job.failure = thrown;
    now = clock_();
    level_ += (now - since) / (2 * static_cast<Nanoseconds>(jobs_.size()));
  } while (stays(job, now));
  --job.awake;
  job.before += now;
  unseat(hand);
  if (job.has_tasks()) return;
  dismiss_idle(job);
  if (job.is_over()) job.caller.called.notify_one();
}

// ---- who works next
// ------------------------------------------------------------------------------

void Pool::enter(Job& job) {
  const Nanoseconds now = clock_();
  const auto less = [&](const Job* a, const Job* b) { return a->service(now) < b->service(now); };
  jobs_.push_back(&job);  // first, for it may throw
  const auto others = std::prev(jobs_.end());
  if (jobs_.begin() != others) {
    const Nanoseconds most = (*std::max_element(jobs_.begin(), others, less))->service(now);
    for (auto each = jobs_.begin(); each != others; ++each)
      (*each)->before += std::max<Nanoseconds>(most - arrears - (*each)->service(now), 0);
    const Nanoseconds least = (*std::min_element(jobs_.begin(), others, less))->service(now);
    level_ = std::max(level_, least);
  }
  job.before = level_ - credit;
  job.young = level_;
}

// Returns: the job that a free hand should go to, or null.
Pool::Job* Pool::next_job(Nanoseconds now) const {
  const bool old_at_work = std::any_of(jobs_.begin(), jobs_.end(), [&](const Job* job) {
    return job->awake > 0 && !job->is_young(now);
  });
  Job* next = nullptr;
  for (Job* job : jobs_) {
    const bool extra = old_at_work && job->hands == 0 && job->is_young(now);
    if (!job->wants_hand() || at_work_ >= threads_ + (extra ? 1 : 0)) continue;
    if (next == nullptr || job->service(now) < next->service(now)) next = job;
  }
  return next;
}

// Whether a hand goes on with the job.
bool Pool::stays(const Job& job, Nanoseconds now) const {
  if (!job.has_tasks()) return false;
  if (at_work_ > threads_ && !job.is_young(now)) return false;
  return std::none_of(jobs_.begin(), jobs_.end(), [&](const Job* other) {
    return other->wants_hand() && other->service(now) + slice < job.service(now);
  });
}

void Pool::seat(Hand& hand, Job& job) {
  ++at_work_;
  ++job.hands;
  hand.job = &job;
}

void Pool::unseat(Hand& hand) {
  --at_work_;
  --hand.job->hands;
  hand.job = nullptr;
}

// The hands that were called to the job and are not awake yet sleep on: nobody waits for them.
void Pool::dismiss_idle(const Job& job) {
  for (Hand* hand : idle_)
    if (hand->job == &job) unseat(*hand);
}

// Gives jobs to hands as long as there is one for another hand: to its own caller first. Where that
// one works already some worker is idle, or has only begun to live: then it looks for itself.
void Pool::call_hands() {
  const Nanoseconds now = clock_();
  while (Job* job = next_job(now)) {
    Hand* hand = &job->caller;
    if (hand->job != nullptr) {
      const auto uncalled = [](const Hand* each) { return each->job == nullptr; };
      const auto idle = std::find_if(idle_.begin(), idle_.end(), uncalled);
      if (idle == idle_.end()) return;
      hand = *idle;
    }
    seat(*hand, *job);
    hand->called.notify_one();
  }
}

}  // namespace tia
