#include "server/jobs/board.h"

#include <algorithm>
#include <atomic>

#include "server/http/error.h"
#include "server/operation/log.h"

namespace tia::server {

namespace {
constexpr std::chrono::seconds between_looks{1};
// What many who watch are told at once, others wait for: the thread that sends for all, and the
// processors. So it is told to a few at a time.
constexpr int told_at_once = 16;
constexpr std::chrono::milliseconds between_few{1};
}  // namespace

/// Watched: a feed as the board and its connection see it. Its page passes between them.
class Board::Watched : public Feed {
 public:
  Watched(Board& board, std::string job, Write write, const FeedRules& rules)
      : job(std::move(job)), board_(board), write_(std::move(write)), rules_(rules) {}

  Piece take() override {
    Piece piece;
    bool has_more = false;
    {
      const std::lock_guard lock(mutex_);
      piece = {std::exchange(page_.bytes, {}), page_.is_last};
      has_more = !page_.is_last && page_.has_more;
    }
    if (has_more) {
      is_due = true;
      board_.wake();
    }
    return piece;
  }
  void listen(std::function<void()> more) override {
    const std::lock_guard lock(mutex_);
    more_ = std::move(more);
    if (more_ && (!page_.bytes.empty() || page_.is_last)) more_();
  }

  // Board's thread: writes the next page if the last one has been taken and there is cause to.
  // Returns: whether it has.
  bool look(bool each_second) {
    {
      const std::lock_guard lock(mutex_);
      if (!page_.bytes.empty() || page_.is_last) return false;
    }
    const bool silent = rules_.comment_after.count() > 0 && Clock::now() >= comment_at_;
    Page page;
    if (is_due.exchange(false) || (each_second && rules_.looks_each_second)) page = write_();
    if (page.bytes.empty() && !page.is_last) {
      if (!silent) return false;
      page.bytes = ":\n\n";
    }
    const std::lock_guard lock(mutex_);
    page_ = std::move(page);
    comment_at_ = Clock::now() + rules_.comment_after;
    if (more_) more_();
    return true;
  }

  const std::string job;
  std::atomic<bool> is_due = true;

 private:
  Board& board_;
  const Write write_;
  const FeedRules rules_;
  Clock::time_point comment_at_ = Clock::now() + rules_.comment_after;
  std::mutex mutex_;
  Page page_;
  std::function<void()> more_;
};

Board::~Board() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
}

std::shared_ptr<Feed> Board::open(const std::string& job, Write write, const FeedRules& rules) {
  auto feed = std::make_shared<Watched>(*this, job, std::move(write), rules);
  const std::lock_guard lock(mutex_);
  std::erase_if(feeds_, [](const auto& each) { return each.expired(); });
  if (static_cast<int>(feeds_.size()) >= most_feeds_)
    throw HttpError("busy",
                    "as many watch jobs as may: half of the connections (option TIA_CONNECTIONS)",
                    {{"Retry-After", "5"}});
  feeds_.push_back(feed);
  if (!thread_.joinable())
    thread_ = std::jthread([this](const std::stop_token& ending) { look(ending); });
  has_news_ = true;
  news_.notify_one();
  return feed;
}

void Board::has_changed(const std::string& job) {
  for (const auto& each : watched())
    if (each->job == job) each->is_due = true;
  wake();
}

int Board::feeds() const { return static_cast<int>(watched().size()); }

std::vector<std::shared_ptr<Board::Watched>> Board::watched() const {
  std::vector<std::shared_ptr<Watched>> all;
  const std::lock_guard lock(mutex_);
  for (const auto& each : feeds_)
    if (auto feed = each.lock()) all.push_back(std::move(feed));
  return all;
}

void Board::wake() {
  const std::lock_guard lock(mutex_);
  has_news_ = true;
  news_.notify_one();
}

void Board::look(const std::stop_token& ending) {
  Clock::time_point looked = Clock::now();
  while (!ending.stop_requested()) {
    {
      std::unique_lock lock(mutex_);
      news_.wait_until(lock, ending, looked + between_looks, [&] { return has_news_; });
      has_news_ = false;
    }
    const bool each_second = Clock::now() - looked >= between_looks;
    if (each_second) looked = Clock::now();
    int told = 0;
    for (const auto& each : watched()) try {
        if (!each->look(each_second) || ++told % told_at_once != 0) continue;
        std::this_thread::sleep_for(between_few);
      } catch (const std::exception& error) {
        log_failure("jobs", error.what());
        each->is_due = true;  // at the next look
      }
  }
}

}  // namespace tia::server
