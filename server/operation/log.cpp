#include "server/operation/log.h"

#include <poll.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <climits>
#include <ctime>
#include <new>
#include <thread>
#include <utility>

#include "core/input/json.h"
#include "server/http/application.h"

namespace tia::server {
namespace {

constexpr std::chrono::milliseconds moment{20};  // for which lines are gathered
constexpr std::chrono::milliseconds glance{50};  // after which an unread pipe is looked at again
constexpr std::chrono::seconds last_wait{1};     // for who does not read, once we end
constexpr std::size_t most_target = 200;         // of whose bytes a line tells

// RFC 3339, to the millisecond; all but that is made once a second.
std::string utc_now() {
  using namespace std::chrono;
  thread_local std::time_t of = 0;
  thread_local char second[40];
  const auto ms = duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
  const std::time_t now = ms / 1000;
  if (std::exchange(of, now) != now) {
    std::tm utc{};
    gmtime_r(&now, &utc);
    std::strftime(second, sizeof second, "%Y-%m-%dT%H:%M:%S.", &utc);
  }
  const std::string fraction = std::to_string(1000 + ms % 1000);
  return second + fraction.substr(1) + 'Z';
}

std::atomic<Log*> current = nullptr;

// Whole lines as far as a pipe takes them in one piece (PIPE_BUF): nobody's bytes come between, and
// one that can be written to takes them without a wait.
std::string_view next_piece(std::string_view text) {
  const std::string_view piece = text.substr(0, PIPE_BUF);
  const auto end = piece.rfind('\n');
  return end == piece.npos ? piece : piece.substr(0, end + 1);
}

// Returns: how many bytes standard error took; 0 where it takes none now, -1 where it never will.
ssize_t write_some(std::string_view text) {
  pollfd error{STDERR_FILENO, POLLOUT, 0};
  if (::poll(&error, 1, static_cast<int>(glance.count())) <= 0) return 0;
  const std::string_view piece = next_piece(text);
  const ssize_t written = ::write(STDERR_FILENO, piece.data(), piece.size());
  if (written >= 0 || (errno != EAGAIN && errno != EINTR)) return written;
  std::this_thread::sleep_for(std::chrono::milliseconds(1));  // one that others have made so
  return 0;
}

// Waits for whoever reads, but once we end only while they do. Returns: whether all was written.
bool write_out(std::string_view text, const std::stop_token& ending = {}) {
  using Clock = std::chrono::steady_clock;
  auto last = Clock::now();
  while (!text.empty()) {
    const ssize_t written = write_some(text);
    if (written < 0) return false;  // nobody can read it
    if (written > 0 || !ending.stop_requested()) last = Clock::now();
    else if (Clock::now() - last > last_wait) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

void write(const std::string& line) {
  if (Log* log = current) log->add(line);
  else write_out(line);
}

/// Line: a JSON object that grows by members; strings are quoted as JSON wants them.
class Line {
 public:
  Line() { add("time", utc_now()); }
  Line& add(const char* name, const Value& value) {
    text_.append(text_.empty() ? "{\"" : ",\"").append(name).append("\":").append(to_json(value));
    return *this;
  }
  Line& add(const char* name, std::size_t count) {
    text_.append(",\"").append(name).append("\":").append(std::to_string(count));
    return *this;
  }
  std::string finish() { return std::move(text_) + "}\n"; }

 private:
  std::string text_;
};

// Returns: whether there was memory to tell of so many lines that have been lost.
bool tell_of_lost(std::size_t count, std::string& lines) {
  try {
    lines += Line().add("lost_lines", count).finish();
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

}  // namespace

Log::Log() : writer_([this](const std::stop_token& ending) { write(ending); }) { current = this; }

Log::~Log() { current = nullptr; }

void Log::add(std::string_view line) {
  const std::lock_guard lock(mutex_);
  if (lines_.size() + line.size() > most_bytes) {
    ++lost_;
    return;
  }
  const bool first = lines_.empty();
  lines_ += line;
  if (first) has_lines_.notify_one();
}

void Log::write(const std::stop_token& ending) {
  std::string lines;
  std::unique_lock lock(mutex_);
  while (has_lines_.wait(lock, ending, [&] { return !lines_.empty(); })) {
    has_lines_.wait_for(lock, ending, moment, [] { return false; });
    lines.clear();
    lines.swap(lines_);
    const long lost = std::exchange(lost_, 0);
    lock.unlock();
    const bool told = lost == 0 || tell_of_lost(static_cast<std::size_t>(lost), lines);
    if (!write_out(lines, ending) && ending.stop_requested()) return;
    lock.lock();
    if (!told) lost_ += lost;
  }
}

void log_exchange(const Exchange& exchange) {
  const Request& request = exchange.request;
  Line line;
  line.add("id", request.id)
      .add("peer", request.peer)
      .add("method", request.method)
      .add("target", request.target.substr(0, most_target))
      .add("status", static_cast<std::size_t>(exchange.response.status))
      .add("request_bytes", request.body_bytes())
      .add("answer_bytes", exchange.body_bytes)
      .add("us", static_cast<std::size_t>(1000 * exchange.ms));
  if (request.trace)
    line.add("trace_id", Value(request.trace->trace_id))
        .add("parent_id", Value(request.trace->parent_id))
        .add("span_id", Value(request.trace->span_id));
  if (!request.key.empty()) line.add("key", Value(request.key));
  const std::string_view problem = exchange.response.problem;
  if (!problem.empty()) line.add("problem", Value(problem));
  for (const auto& [name, value] : exchange.response.log) line.add(name.c_str(), value);
  write(line.finish());
}

void log_event(std::string_view what) { write(Line().add("event", Value(what)).finish()); }

void log_failure(const std::string& id, std::string_view what) {
  write(Line().add("id", id).add("failure", Value(what)).finish());
}

}  // namespace tia::server
