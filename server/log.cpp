#include "server/log.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <utility>

#include "core/input/json.h"
#include "server/http/http_server.h"

namespace tia::server {
namespace {

constexpr std::chrono::milliseconds moment{20};  // for which lines are gathered
constexpr std::size_t most_target = 200;         // of whose bytes a line tells

// RFC 3339, to the millisecond; all but that is made once a second.
std::string utc_now() {
  using namespace std::chrono;
  thread_local std::time_t of = 0;
  thread_local std::string second;
  const auto ms = duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
  const std::time_t now = ms / 1000;
  if (std::exchange(of, now) != now) {
    std::tm utc{};
    gmtime_r(&now, &utc);
    char text[40];
    second.assign(text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S.", &utc));
  }
  const std::string fraction = std::to_string(1000 + ms % 1000);
  return second + fraction.substr(1) + 'Z';
}

std::atomic<Log*> current = nullptr;

void write_out(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

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
    if (lost > 0) lines += Line().add("lost_lines", static_cast<std::size_t>(lost)).finish();
    write_out(lines);
    lock.lock();
  }
  write_out(lines_);
}

void log_exchange(const Exchange& exchange) {
  const Request& request = exchange.request;
  Line line;
  line.add("id", request.id)
      .add("peer", request.peer)
      .add("method", request.method)
      .add("target", request.target.substr(0, most_target))
      .add("status", static_cast<std::size_t>(exchange.response.status))
      .add("request_bytes", request.body.size())
      .add("answer_bytes", exchange.body_bytes)
      .add("us", static_cast<std::size_t>(1000 * exchange.ms));
  for (const auto& [name, value] : exchange.response.log) line.add(name.c_str(), value);
  write(line.finish());
}

void log_failure(const std::string& id, std::string_view what) {
  write(Line().add("id", id).add("failure", Value(what)).finish());
}

}  // namespace tia::server
