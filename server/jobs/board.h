// Who watches jobs, and is told of them: by one thread for all, so that no worker waits.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "server/http/message.h"

namespace tia::server {

/// Board: hands feeds their pages when there is something to tell. Of each it holds one page, until
/// its connection has taken that. It outlives them.
class Board {
 public:
  /// Page: what a feed sends next, at most some KiB; empty where nothing has come.
  struct Page {
    std::string bytes;
    bool is_last = false, has_more = false;
  };
  /// Called on the board's thread.
  using Write = std::function<Page()>;
  /// FeedRules: when a page is written though nothing has changed.
  struct FeedRules {
    std::chrono::milliseconds comment_after{};  ///< a comment of server-sent events; 0: none
    bool looks_each_second = false;
  };

  explicit Board(int most_feeds) : most_feeds_(most_feeds) {}
  ~Board();
  Board(const Board&) = delete;
  Board& operator=(const Board&) = delete;

  /// Errors: HttpError (busy) where as many are open as may be.
  std::shared_ptr<Feed> open(const std::string& job, Write write, const FeedRules& rules);
  /// Any thread may call.
  void has_changed(const std::string& job);
  int feeds() const;

 private:
  class Watched;
  void look(const std::stop_token& ending);
  std::vector<std::shared_ptr<Watched>> watched() const;
  void wake();

  const int most_feeds_;
  mutable std::mutex mutex_;
  std::condition_variable_any news_;
  bool has_news_ = false;
  std::vector<std::weak_ptr<Watched>> feeds_;
  std::jthread thread_;  // from the first feed on
};

}  // namespace tia::server
