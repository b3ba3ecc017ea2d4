#include "server/requests/live_scenes.h"

#include <utility>

#include "server/stores/random_key.h"

namespace tia::server {

int LiveScene::change(const Change& by) {
  const std::lock_guard one_by_one(changing_);
  const std::shared_ptr<const RenderRequest> before = [&] {
    const std::lock_guard lock(mutex_);
    return now_.request;
  }();
  auto after = std::make_shared<const RenderRequest>(by(*before));
  const std::lock_guard lock(mutex_);
  now_.request = std::move(after);
  changed_.notify_all();
  return ++now_.change;
}

std::optional<LiveScene::State> LiveScene::newer_than(int change, Clock::time_point until,
                                                      const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  changed_.wait_until(lock, stop, until, [&] { return now_.change > change || is_retired_; });
  if (now_.change <= change) return std::nullopt;
  return now_;
}

void LiveScene::retire() {
  const std::lock_guard lock(mutex_);
  is_retired_ = true;
  changed_.notify_all();
}

bool LiveScene::is_retired() const {
  const std::lock_guard lock(mutex_);
  return is_retired_;
}

LiveScenes::Opened::Opened(LiveScenes& all, std::string client, RenderRequest first)
    : id(random_key()),
      scene(std::make_shared<LiveScene>(std::move(first))),
      all_(all),
      client_(std::move(client)) {
  const std::lock_guard lock(all.mutex_);
  std::string& newest = all.ids_[client_];
  if (const auto older = all.by_id_.find(newest); older != all.by_id_.end())
    older->second->retire();
  all.by_id_.emplace(id, scene);
  newest = id;
}

LiveScenes::Opened::~Opened() {
  const std::lock_guard lock(all_.mutex_);
  all_.by_id_.erase(id);
  if (const auto newest = all_.ids_.find(client_); newest->second == id) all_.ids_.erase(newest);
}

std::shared_ptr<LiveScene> LiveScenes::find(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto found = by_id_.find(id);
  return found != by_id_.end() ? found->second : nullptr;
}

}  // namespace tia::server
