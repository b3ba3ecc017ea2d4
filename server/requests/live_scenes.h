// What live streams are to show: requests that change while their pictures are looked at.
#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>

#include "server/http/message.h"
#include "server/requests/render_request.h"

namespace tia::server {

/// LiveScene: one stream's request as it is by now. Any thread may call.
class LiveScene {
 public:
  /// State: a request, and how many changes have come to it.
  struct State {
    std::shared_ptr<const RenderRequest> request;
    int change = 0;
  };
  explicit LiveScene(RenderRequest first)
      : now_{std::make_shared<const RenderRequest>(std::move(first)), 0} {}

  /// Changes it by what `by` makes of it, one change after the other. Returns: its number, from 1.
  /// Errors: what `by` throws; then it stays as it was.
  using Change = std::function<RenderRequest(const RenderRequest& now)>;
  int change(const Change& by);
  /// The newest state, where it is newer than that change: waits for one until then; or nothing.
  std::optional<State> newer_than(int change, Clock::time_point until, const std::stop_token& stop);
  /// Another stream takes its place.
  void retire();
  bool is_retired() const;

 private:
  std::mutex changing_;  // by whom it is changed
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  State now_;
  bool is_retired_ = false;
};

/// LiveScenes: those that are shown, by ids that nobody guesses; one a client. Any thread may call.
class LiveScenes {
 public:
  /// Opened: one that is shown, until the end of this.
  struct Opened {
    Opened(LiveScenes& all, std::string client, RenderRequest first);
    Opened(const Opened&) = delete;
    Opened& operator=(const Opened&) = delete;
    ~Opened();

    const std::string id;
    const std::shared_ptr<LiveScene> scene;

   private:
    LiveScenes& all_;
    const std::string client_;
  };
  /// Opens one; the client's older one is retired. Errors: StorageError.
  std::shared_ptr<const Opened> open(const std::string& client, RenderRequest first) {
    return std::make_shared<const Opened>(*this, client, std::move(first));
  }
  /// The one of that id, or null.
  std::shared_ptr<LiveScene> find(const std::string& id) const;

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<LiveScene>> by_id_;
  std::map<std::string, std::string> ids_;  // of clients, the newest
};

}  // namespace tia::server
