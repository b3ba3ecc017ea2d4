#include "core/parallel/pool.h"

#include <algorithm>
#include <utility>

#include "core/parallel/lone.h"

namespace tia {
namespace {

void in_turn(int count, const std::stop_token& stop, const std::function<void(int)>& task) {
  for (int i = 0; i < count; ++i) {
    end_if_asked(stop);
    task(i);
  }
  end_if_asked(stop);
}

}  // namespace

Pool::Pool(int threads, Clock clock) : hands_(std::make_unique<Hands>(threads, std::move(clock))) {}

Pool::~Pool() = default;

int Pool::threads() const { return hands_->threads(); }

int Pool::most_more_threads() const { return Hands::most_suspended(threads()); }

void Pool::also_for(Flow& flow, std::uint64_t client) { hands_->also_for(flow, client); }

void Pool::for_each(int count, int max_threads, const std::stop_token& stop,
                    const std::function<void(int)>& task, Flow* flow) {
  if (Lone* lone = Lone::present(); lone != nullptr && std::min(count, max_threads) > 1)
    return lone->aside([&] { for_each(count, max_threads, stop, task, flow); });
  if (Hands::is_inside_task()) return in_turn(count, stop, task);
  Flow own;
  Job job(*hands_, count, std::min(std::max(max_threads, 1), count), stop, task,
          flow != nullptr ? *flow : own);
  hands_->share(job);
}

void Pool::alone(const std::function<void()>& work, const std::stop_token& stop, Flow* flow) {
  if (Hands::is_inside_task()) return work();
  Flow own;
  Lone(*hands_, stop, flow != nullptr ? *flow : own).work(work);
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

}  // namespace tia
