#include "core/render/pool.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <utility>

#include "core/input/task_context.h"

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

struct Pool::Job : Turn {
  Job(int tasks, int most, const std::stop_token& asked, const std::function<void(int)>& what,
      Flow& request, bool alone = false)
      : Turn(tasks, most, request), is_alone(alone), stop(asked), task(what) {}

  const bool is_alone;  // only its caller can do it

  const std::stop_token& stop;
  const std::function<void(int)>& task;
  void* const context = task_context;    // the caller's
  std::exception_ptr failure = nullptr;  // guarded by the pool's mutex, as is what a turn counts
  Hand caller{};

  // Takes tasks until that time. Returns: what a task threw.
  std::exception_ptr run(const Clock& clock, Nanoseconds end) {
    inside_task = true;
    void* const outside = std::exchange(task_context, context);
    std::exception_ptr thrown = nullptr;
    try {
      run_tasks(clock, end);
    } catch (...) {
      next = count;
      thrown = std::current_exception();
    }
    task_context = outside;
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

/// Lone: a caller that does its one task alone, which is not over until all of it is done.
class Pool::Lone : public Courtesy {
 public:
  Lone(Pool& pool, const std::stop_token& stop, Flow& flow)
      : pool_(pool), stop_(stop), job_(1, 1, stop, nothing, flow, true) {
    const std::lock_guard lock(pool_.mutex_);
    pool_.turns_.enter(job_, pool_.clock_());
    pool_.call_hands();
  }
  ~Lone() {
    const std::lock_guard lock(pool_.mutex_);
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
  void let_others_go() override {
    const Nanoseconds now = pool_.clock_();
    if (now - since_ < Turns::look) return;
    if (stop_.stop_requested()) throw Stopped();
    std::unique_lock lock(pool_.mutex_);
    pool_.turns_.spend(job_, now - since_);
    since_ = now;
    if (pool_.turns_.stays(job_, now)) return;
    rest();
    pool_.unseat(job_.caller);
    pool_.call_hands();
    lock.unlock();
    take_turn();
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
    while (job_.caller.job == nullptr) {
      if (stop_.stop_requested()) throw Stopped();
      pool_.wait(job_.caller, lock, stop_, [&] { return job_.caller.job != nullptr; });
    }
    since_ = pool_.clock_();
    Turns::begin(job_, since_);
    at_work_ = true;
    inside_task = true, courtesy = this, lone = this;
  }
  void rest() {
    inside_task = false, courtesy = nullptr, lone = nullptr;
    const Nanoseconds now = pool_.clock_();
    pool_.turns_.spend(job_, now - since_);
    Turns::end(job_, now);
    at_work_ = false;
  }

  static inline const std::function<void(int)> nothing;
  Pool& pool_;
  const std::stop_token& stop_;
  Job job_;
  Nanoseconds since_ = 0;
  bool at_work_ = false;
};

constinit thread_local Pool::Lone* Pool::lone = nullptr;

Nanoseconds Pool::steady_clock() {
  using namespace std::chrono;
  return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

Pool::Pool(int threads, Clock clock) : clock_(std::move(clock)), turns_(threads) {
  idle_.reserve(static_cast<std::size_t>(threads));
  for (int i = 1; i < threads; ++i)
    workers_.emplace_back([this, &hand = hands_.emplace_back()](const std::stop_token& ending) {
      serve(hand, ending);
    });
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
  Job job(count, std::min(std::max(max_threads, 1), count), stop, task,
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
  hand.called.wait(lock, [&] { return job.hands == 0; });
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
    Job* job = nullptr;
    do call_hands();
    while ((job = next_job()) != nullptr && job->is_alone);  // which its caller has to do
    if (job != nullptr) {
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
  Nanoseconds now = clock_();
  Turns::begin(job, now);
  do {
    const Nanoseconds since = now;
    lock.unlock();
    const std::exception_ptr thrown = job.run(clock_, since + Turns::look);
    lock.lock();
    if (thrown && !job.failure) job.failure = thrown;
    now = clock_();
    turns_.spend(job, now - since);
  } while (turns_.stays(job, now));
  Turns::end(job, now);
  unseat(hand);
  if (job.has_tasks()) return;
  dismiss_idle(job);
  if (job.is_over()) job.caller.called.notify_one();
}

// Until there is news, or for a while: those at work grow old without telling, which may make room.
template <class News>
void Pool::wait(Hand& hand, std::unique_lock<std::mutex>& lock, const std::stop_token& stop,
                const News& news) {
  constexpr std::chrono::milliseconds while_nothing_is_told{10};
  if (!hand.called.wait_for(lock, stop, while_nothing_is_told, news)) call_hands();
}

Pool::Job* Pool::next_job() const { return static_cast<Job*>(turns_.next(clock_())); }

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

// Calls hands as long as a job may have one more: its own caller first. Where that one is called
// already some worker is idle, or has only begun to live: then it looks for itself.
void Pool::call_hands() {
  while (Job* job = next_job()) {
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
