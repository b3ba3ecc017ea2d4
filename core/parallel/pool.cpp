#include "core/parallel/pool.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <utility>

#include "core/parallel/task_context.h"

namespace tia {
namespace {

// Whether this thread is within a task or lone work.
thread_local bool inside_task = false;

void in_turn(int count, const std::stop_token& stop, const std::function<void(int)>& task) {
  for (int i = 0; i < count; ++i) {
    end_if_asked(stop);
    task(i);
  }
  end_if_asked(stop);
}

// How many workers may be suspended at once. The parked pictures of one client hold them: of eight
// with 8 threads another client had 12 % of what it has alone where 8 might be, 40 % where 64
// might. Of two threads an even share is one, which is the caller.
int most_suspended(int threads) {
  if (threads <= 2) return threads > 1 ? threads : 0;
  return std::max(threads, std::min(8 * threads, 64));
}

}  // namespace

/// Hand: a thread that can work: one of the pool's own, or a caller, which has but its own job.
/// Within a task it lets jobs go first that have had less: it is suspended, and the task with it.
struct Pool::Hand : Courtesy {
  Hand(Pool& of, bool caller) : pool(of), is_caller(caller) {}
  void let_others_go() override { pool.let_others_go(*this); }

  Pool& pool;
  const bool is_caller;
  Job* job = nullptr;              // where it works, or is called to while it sleeps
  Nanoseconds since = 0;           // when it began what has not been told to the turns
  Hand* next_suspended = nullptr;  // of its job
  std::condition_variable_any called;
};

/// Job: what a caller wants done, and who is at it.
struct Pool::Job : Turn {
  Job(Pool& pool, int tasks, int most, const std::stop_token& asked,
      const std::function<void(int)>& what, Flow& request, bool alone = false)
      : Turn(tasks, most, request), is_alone(alone), stop(asked), task(what), caller(pool, true) {}

  const bool is_alone;  // only its caller can do it

  const std::stop_token& stop;
  const std::function<void(int)>& task;
  void* const context = task_context;    // the caller's
  std::exception_ptr failure = nullptr;  // guarded by the pool's mutex, as is what a turn counts
  Hand* suspended_hands = nullptr;       // the last one first
  Hand caller;

  // Has the hand take tasks until it is time to look for others. Returns: what a task threw.
  std::exception_ptr run(Hand& hand) {
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
  void run_tasks(const Hand& hand) {
    do {
      if (stop.stop_requested()) next = count;
      const int i = next.fetch_add(1, std::memory_order_relaxed);
      if (i >= count) return;
      task(i);
    } while (hand.pool.clock_() < hand.since + Turns::look);
  }
};

/// Lone: a caller that does its one task alone, which is not over until all of it is done.
class Pool::Lone {
 public:
  Lone(Pool& pool, const std::stop_token& stop, Flow& flow)
      : pool_(pool), job_(pool, 1, 1, stop, nothing, flow, true) {
    const std::lock_guard lock(pool_.mutex_);
    pool_.turns_.enter(job_, pool_.clock_());
    pool_.call_hands();
  }
  ~Lone() {
    std::unique_lock lock(pool_.mutex_);
    if (at_work_) rest();
    if (job_.caller.job != nullptr) pool_.unseat(job_.caller);
    job_.next = job_.count;
    pool_.turns_.leave(job_, pool_.clock_());
    pool_.call_hands();
  }
  Lone(const Lone&) = delete;
  Lone& operator=(const Lone&) = delete;

  void work(const std::function<void()>& work) {
    take_turn();
    work();
  }
  /// Lets `work` take turns of its own meanwhile. What it throws ends the lone work, too.
  void aside(const std::function<void()>& work) {
    std::unique_lock lock(pool_.mutex_);
    rest();
    pool_.unseat(job_.caller);
    Turns::pause(job_, pool_.clock_());
    pool_.call_hands();
    lock.unlock();
    work();
    lock.lock();
    Turns::resume(job_);
    pool_.call_hands();
    lock.unlock();
    take_turn();
  }

 private:
  void take_turn() {
    std::unique_lock lock(pool_.mutex_);
    Hand& hand = job_.caller;
    while (hand.job == nullptr) {
      if (job_.stop.stop_requested()) throw Stopped();
      pool_.wait(hand, lock, job_.stop, [&] { return hand.job != nullptr; });
    }
    pool_.begin(hand);
    at_work_ = true;
    inside_task = true, courtesy = &hand, lone = this;
  }
  void rest() {
    inside_task = false, courtesy = nullptr, lone = nullptr;
    pool_.tell(job_.caller);
    Turns::end(job_, job_.caller.since);
    at_work_ = false;
  }

  static inline const std::function<void(int)> nothing;
  Pool& pool_;
  Job job_;
  bool at_work_ = false;
};

constinit thread_local Pool::Lone* Pool::lone = nullptr;

Nanoseconds Pool::steady_clock() {
  using namespace std::chrono;
  return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

// A job may have its caller and all other threads, whatever workers are suspended within tasks.
Pool::Pool(int threads, Clock clock)
    : clock_(std::move(clock)), turns_(threads), may_suspend_(most_suspended(threads)) {
  const int workers = threads - 1 + may_suspend_;
  idle_.reserve(static_cast<std::size_t>(workers));
  for (int i = 0; i < workers; ++i)
    workers_.emplace_back([this, &hand = hands_.emplace_back(*this, false)](
                              const std::stop_token& ending) { serve(hand, ending); });
  // All of them live once this is made, and need nothing more for that.
  for (bool all = false; !all; std::this_thread::yield()) {
    const std::lock_guard lock(mutex_);
    all = static_cast<int>(idle_.size()) == workers;
  }
}

Pool::~Pool() {
  for (std::jthread& worker : workers_) worker.request_stop();
}

void Pool::for_each(int count, int max_threads, const std::stop_token& stop,
                    const std::function<void(int)>& task, Flow* flow) {
  if (lone != nullptr && std::min(count, max_threads) > 1)
    return lone->aside([&] { for_each(count, max_threads, stop, task, flow); });
  if (inside_task) return in_turn(count, stop, task);
  Flow own;
  Job job(*this, count, std::min(std::max(max_threads, 1), count), stop, task,
          flow != nullptr ? *flow : own);
  Hand& hand = job.caller;
  std::unique_lock lock(mutex_);
  turns_.enter(job, clock_());
  call_hands();
  const auto has_news = [&] { return hand.job != nullptr || job.is_over(); };
  while (!job.is_over() && !stop.stop_requested()) {
    wait(hand, lock, stop, has_news);
    if (hand.job != nullptr) work(hand, lock);
    call_hands();
  }
  if (hand.job != nullptr) unseat(hand);  // called when it had been stopped
  job.next = count;                       // it may have been stopped while nobody was at work
  dismiss_idle(job);
  call_hands();
  hand.called.wait(lock, [&] { return job.is_over(); });
  turns_.leave(job, clock_());
  lock.unlock();
  if (job.failure) std::rethrow_exception(job.failure);
  end_if_asked(stop);
}

void Pool::alone(const std::function<void()>& work, const std::stop_token& stop, Flow* flow) {
  if (inside_task) return work();
  Flow own;
  Lone(*this, stop, flow != nullptr ? *flow : own).work(work);
}

Workers Pool::workers(int max_threads, const std::stop_token& stop, Flow* flow) {
  const auto share = [this, max_threads, stop, flow](int count, const Workers::Task& task) {
    for_each(count, max_threads, stop, task, flow);
  };
  const auto lone_work = [this, stop, flow](const std::function<void()>& work) {
    alone(work, stop, flow);
  };
  return Workers(share, lone_work, stop);
}

void Pool::serve(Hand& hand, const std::stop_token& ending) {
  std::unique_lock lock(mutex_);
  for (;;) {
    call_hands();
    const auto can = [](const Job& job) { return !job.is_alone && job.suspended == 0; };
    if (Job* const job = next_job(can)) {
      seat(hand, *job);
    } else {
      idle_.push_back(&hand);
      if (!hand.called.wait(lock, ending, [&] { return hand.job != nullptr; })) return;
      idle_.erase(std::find(idle_.begin(), idle_.end(), &hand));
    }
    call_hands();  // to the places of hands that were dismissed
    work(hand, lock);
  }
}

// From a hand's coming to its leaving. The mutex is free while tasks run.
void Pool::work(Hand& hand, std::unique_lock<std::mutex>& lock) {
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

void Pool::begin(Hand& hand) {
  hand.since = clock_();
  Turns::begin(*hand.job, hand.since);
}

void Pool::tell(Hand& hand) {
  const Nanoseconds now = clock_();
  turns_.spend(*hand.job, now - std::exchange(hand.since, now));
}

// As at the end of a task. A worker is suspended only while enough of them are left for others:
// else parked jobs would keep them all.
void Pool::let_others_go(Hand& hand) {
  if (clock_() - hand.since < Turns::look) return;
  Job& job = *hand.job;
  if (job.stop.stop_requested()) throw Stopped();
  std::unique_lock lock(mutex_);
  tell(hand);
  if (turns_.stays(job, hand.since) || (!hand.is_caller && may_suspend_ == 0)) return;
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

void Pool::suspend(Hand& hand, Job& job) {
  hand.next_suspended = std::exchange(job.suspended_hands, &hand);
  ++job.suspended;
  if (!hand.is_caller) --may_suspend_;
}

void Pool::restore(Hand& hand, Job& job) {
  Hand** at = &job.suspended_hands;
  while (*at != &hand) at = &(*at)->next_suspended;
  *at = hand.next_suspended;
  --job.suspended;
  if (!hand.is_caller) ++may_suspend_;
}

// Until there is news, or for a while: those at work grow old without telling, which may make room.
template <class News>
void Pool::wait(Hand& hand, std::unique_lock<std::mutex>& lock, const std::stop_token& stop,
                const News& news) {
  constexpr std::chrono::milliseconds while_nothing_is_told{10};
  if (!hand.called.wait_for(lock, stop, while_nothing_is_told, news)) call_hands();
}

// Returns: the job that one more hand should go to, of those that `can` have one.
template <class Can>
Pool::Job* Pool::next_job(const Can& can) const {
  return static_cast<Job*>(
      turns_.next(clock_(), [&](Turn& turn) { return can(static_cast<Job&>(turn)); }));
}

void Pool::seat(Hand& hand, Job& job) {
  turns_.call(job, clock_());
  hand.job = &job;
}

void Pool::unseat(Hand& hand) {
  turns_.dismiss(*hand.job);
  hand.job = nullptr;
}

// The hands that were called to the job and are not awake yet sleep on: nobody waits for them.
void Pool::dismiss_idle(const Job& job) {
  for (Hand* hand : idle_)
    if (hand->job == &job) unseat(*hand);
}

// Calls hands as long as a job may have one more.
void Pool::call_hands() {
  const auto can = [this](Job& job) { return hand_for(job) != nullptr; };
  while (Job* job = next_job(can)) {
    Hand* const hand = hand_for(*job);
    if (job->suspended > 0) restore(*hand, *job);
    seat(*hand, *job);
    hand->called.notify_one();
  }
}

// First one that is suspended within the job's tasks, then its own caller, then an idle worker;
// null without any. A worker that has only begun to live looks for itself.
Pool::Hand* Pool::hand_for(Job& job) const {
  if (job.suspended > 0) return job.suspended_hands;
  if (job.caller.job == nullptr) return &job.caller;
  const auto is_uncalled = [](const Hand* each) { return each->job == nullptr; };
  const auto idle = std::find_if(idle_.begin(), idle_.end(), is_uncalled);
  return idle != idle_.end() ? *idle : nullptr;
}

}  // namespace tia
