#include "server/jobs/event_stream.h"

#include "core/input/json.h"
#include "server/jobs/job_json.h"
#include "server/jobs/runner.h"

namespace tia::server {
namespace {

constexpr int page_of_events = 64;
constexpr std::size_t most_page_bytes = 8 << 10;
constexpr std::chrono::seconds comment_after{15};

std::string event_text(const JobEvent& event) {
  return "id: " + std::to_string(event.id) + "\nevent: " + event.name + "\ndata: " + event.data +
         "\n\n";
}

}  // namespace

std::shared_ptr<Feed> event_feed(const std::string& id, std::int64_t after, JobStore& store,
                                 Board& board) {
  const auto write = [id, after, &store]() mutable {
    Board::Page page;
    const auto events = store.events(id, after, page_of_events);
    if (events.empty()) {
      const auto job = store.find(id);
      page.has_more = job && after < job->events;  // they have come just now
      page.is_last = !job || (is_last(job->state) && !page.has_more);
      return page;
    }
    for (const JobEvent& event : events) {
      if (page.bytes.size() > most_page_bytes) break;
      page.bytes += event_text(event);
      page.has_more = event.name == "state";  // perhaps the last one
      after = event.id;
    }
    page.has_more =
        page.has_more || after < events.back().id || events.size() == std::size_t{page_of_events};
    return page;
  };
  return board.open(id, write, {.comment_after = comment_after});
}

std::shared_ptr<Feed> status_feed(const Job& job, int most_seconds, JobStore& store, Board& board) {
  const auto until = Clock::now() + std::chrono::seconds(most_seconds);
  const auto write = [job, until, &store] {
    const auto now = store.find(job.id);
    if (now && now->events == job.events && Clock::now() < until) return Board::Page{};
    return Board::Page{to_json(job_status(now.value_or(job), Runner::now(), store.is_durable())),
                       true, false};
  };
  return board.open(job.id, write, {.looks_each_second = true});
}

}  // namespace tia::server
