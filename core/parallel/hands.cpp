#include "core/parallel/hands.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <system_error>
#include <utility>

namespace tia {
namespace {

// Whether this thread is within a task or lone work.
constinit thread_local bool inside_task = false;

Nanoseconds steady_clock() {
  using namespace std::chrono;
  return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

}  // namespace

// ---- jobs -------------------------------------------------------------------------------------

std::exception_ptr Job::run(Hand& hand) {
  inside_task = true;
  courtesy = &hand;
  void* const outside = std::exchange(task_context, context);
  std::exception_ptr thrown = nullptr;
  try {
    run_tasks(hand);
  } catch (...) {
    next = count;
    thrown = std::current_exception();
  }
  task_context = outside;
  courtesy = nullptr;
  inside_task = false;
  return thrown;
}

void Job::run_tasks(const Hand& hand) {
  do {
    if (stop.stop_requested()) next = count;
    const int i = next.fetch_add(1, std::memory_order_relaxed);
    if (i >= count) return;
    task(i);
  } while (hand.hands.now() < hand.since + Turns::look);
}

bool Hands::is_inside_task() { return inside_task; }

void Hands::share(Job& job) {
  Hand& hand = job.caller;
  std::unique_lock lock(mutex_);
  turns_.enter(job, clock_());
  call_hands();
  const auto has_news = [&] { return hand.job != nullptr || job.is_over(); };
  while (!job.is_over() && !job.stop.stop_requested()) {
    wait(hand, lock, job.stop, has_news);
    if (hand.job != nullptr) work(hand, lock);
    call_hands();
  }
  if (hand.job != nullptr) unseat(hand);  // called when it had been stopped
  job.next = job.count;                   // it may have been stopped while nobody was at work
  dismiss_idle(job);
  call_hands();
  hand.called.wait(lock, [&] { return job.is_over(); });
  turns_.leave(job, clock_());
  lock.unlock();
  if (job.failure) std::rethrow_exception(job.failure);
  end_if_asked(job.stop);
}

void Hands::also_for(Flow& flow, std::uint64_t client) {
  const std::lock_guard lock(mutex_);
  turns_.also_for(flow, client, clock_());
  call_hands();
}

// ---- lone work ----------------------------------------------------------------------------------

void Hands::enter(Job& job) {
  const std::lock_guard lock(mutex_);
  turns_.enter(job, clock_());
  call_hands();
}

void Hands::leave(Job& job) {
  const std::lock_guard lock(mutex_);
  if (job.caller.job != nullptr) unseat(job.caller);
  job.next = job.count;
  turns_.leave(job, clock_());
  call_hands();
}

void Hands::begin_alone(Job& job) {
  std::unique_lock lock(mutex_);
  Hand& hand = job.caller;
  while (hand.job == nullptr) {
    if (job.stop.stop_requested()) throw Stopped();
    wait(hand, lock, job.stop, [&] { return hand.job != nullptr; });
  }
  begin(hand);
  inside_task = true;
  courtesy = &hand;
}

void Hands::end_alone(Job& job) {
  const std::lock_guard lock(mutex_);
  inside_task = false;
  courtesy = nullptr;
  tell(job.caller);
  Turns::end(job, job.caller.since);
}

void Hands::pause(Job& job) {
  const std::lock_guard lock(mutex_);
  unseat(job.caller);
  Turns::pause(job, clock_());
  call_hands();
}

void Hands::resume(Job& job) {
  const std::lock_guard lock(mutex_);
  Turns::resume(job);
  call_hands();
}

// ---- workers ------------------------------------------------------------------------------------

Hands::Hands(int threads, Clock clock)
    : clock_(clock ? std::move(clock) : steady_clock), turns_(threads) {
  const auto workers = static_cast<std::size_t>(threads - 1);
  std::unique_lock lock(mutex_);
  while (workers_.size() < workers)
    if (!add_worker())
      throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
  // All of them live once this is made, and need nothing more for that.
  while (idle_.size() < workers) {
    lock.unlock();
    std::this_thread::yield();
    lock.lock();
  }
}

Hands::~Hands() {
  for (std::jthread& worker : workers_) worker.request_stop();
}

// Domain: the mutex is held. Returns: whether there was room for one. It is nobody's in particular.
bool Hands::add_worker() {
  void* const outside = std::exchange(task_context, nullptr);
  const std::size_t before = workers_.size();
  try {
    idle_.reserve(before + 1);
    Hand& hand = hands_.emplace_back(*this, false);
    workers_.emplace_back([this, &hand](const std::stop_token& ending) { serve(hand, ending); });
  } catch (const std::exception&) {
    if (hands_.size() > before) hands_.pop_back();
  }
  task_context = outside;
  return workers_.size() > before;
}

void Hands::serve(Hand& hand, const std::stop_token& ending) {
  std::unique_lock lock(mutex_);
  for (;;) {
    idle_.push_back(&hand);  // before anyone is called: it may be the one
    call_hands();
    if (!hand.called.wait(lock, ending, [&] { return hand.job != nullptr; })) return;
    idle_.erase(std::find(idle_.begin(), idle_.end(), &hand));
    call_hands();  // to the places of hands that were dismissed
    work(hand, lock);
  }
}

// From a hand's coming to its leaving. The mutex is free while tasks run.
void Hands::work(Hand& hand, std::unique_lock<std::mutex>& lock) {
  Job& job = *hand.job;
  begin(hand);
  do {
    lock.unlock();
    const std::exception_ptr thrown = job.run(hand);
    lock.lock();
    if (thrown && !job.failure) job.failure = thrown;
    tell(hand);
  } while (job.has_tasks() && turns_.stays(job, hand.since));
  Turns::end(job, hand.since);
  unseat(hand);
  if (job.has_tasks()) return;
  dismiss_idle(job);
  if (job.is_over()) job.caller.called.notify_one();
}

void Hands::begin(Hand& hand) {
  hand.since = clock_();
  Turns::begin(*hand.job, hand.since);
}

void Hands::tell(Hand& hand) {
  const Nanoseconds now = clock_();
  turns_.spend(*hand.job, now - std::exchange(hand.since, now), now);
}

// ---- within tasks -------------------------------------------------------------------------------

void Hand::let_others_go() { hands.let_others_go(*this); }

// As at the end of a task.
void Hands::let_others_go(Hand& hand) {
  if (clock_() - hand.since < Turns::look) return;
  Job& job = *hand.job;
  if (job.stop.stop_requested()) throw Stopped();
  std::unique_lock lock(mutex_);
  tell(hand);
  if (turns_.stays(job, hand.since) || !may_suspend(hand)) return;
  Turns::end(job, hand.since);
  unseat(hand);
  suspend(hand, job);
  call_hands();
  while (hand.job == nullptr && !job.stop.stop_requested())
    wait(hand, lock, job.stop, [&] { return hand.job != nullptr; });
  if (hand.job == nullptr) {  // it has to end, which it does as if it had been called
    restore(hand, job);
    seat(hand, job);
  }
  begin(hand);
  if (job.stop.stop_requested()) throw Stopped();
}

// A worker is suspended only where enough of them are left for others: else parked jobs would keep
// them all.
bool Hands::may_suspend(const Hand& hand) {
  if (hand.is_caller) return true;
  const int left = static_cast<int>(workers_.size()) - suspended_ - 1;
  return left >= threads() - 1 || (suspended_ < most_suspended(threads()) && add_worker());
}

void Hands::suspend(Hand& hand, Job& job) {
  hand.next_suspended = std::exchange(job.suspended_hands, &hand);
  ++job.suspended;
  if (!hand.is_caller) ++suspended_;
}

void Hands::restore(Hand& hand, Job& job) {
  Hand** at = &job.suspended_hands;
  while (*at != &hand) at = &(*at)->next_suspended;
  *at = hand.next_suspended;
  --job.suspended;
  if (!hand.is_caller) --suspended_;
}

// ---- who is called where ------------------------------------------------------------------------

// Until there is news, or for a while: those at work grow old without telling, which may make room.
template <class News>
void Hands::wait(Hand& hand, std::unique_lock<std::mutex>& lock, const std::stop_token& stop,
                 const News& news) {
  constexpr std::chrono::milliseconds while_nothing_is_told{10};
  if (!hand.called.wait_for(lock, stop, while_nothing_is_told, news)) call_hands();
}

// Returns: the job that one more hand should go to, of those that `can` have one.
template <class Can>
Job* Hands::next_job(const Can& can) const {
  return static_cast<Job*>(
      turns_.next(clock_(), [&](Turn& turn) { return can(static_cast<Job&>(turn)); }));
}

void Hands::seat(Hand& hand, Job& job) {
  turns_.call(job, clock_());
  hand.job = &job;
}

void Hands::unseat(Hand& hand) {
  turns_.dismiss(*hand.job);
  hand.job = nullptr;
}

// The hands that were called to the job and are not awake yet sleep on: nobody waits for them.
void Hands::dismiss_idle(const Job& job) {
  for (Hand* hand : idle_)
    if (hand->job == &job) unseat(*hand);
}

// Calls hands as long as a job may have one more.
void Hands::call_hands() {
  const auto can = [this](Job& job) { return hand_for(job) != nullptr; };
  while (Job* job = next_job(can)) {
    Hand* const hand = hand_for(*job);
    if (job->suspended > 0) restore(*hand, *job);
    seat(*hand, *job);
    hand->called.notify_one();
  }
}

// First one that is suspended within the job's tasks, then its own caller, then the worker that has
// been idle for the shortest time; null without any.
Hand* Hands::hand_for(Job& job) const {
  if (job.suspended > 0) return job.suspended_hands;
  if (job.caller.job == nullptr) return &job.caller;
  const auto is_uncalled = [](const Hand* each) { return each->job == nullptr; };
  const auto idle = std::find_if(idle_.rbegin(), idle_.rend(), is_uncalled);
  return idle != idle_.rend() ? *idle : nullptr;
}

}  // namespace tia
