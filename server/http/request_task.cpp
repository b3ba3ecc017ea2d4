#include "server/http/request_task.h"

#include <utility>

#include "server/http/answer_writer.h"
#include "server/http/timeouts.h"

namespace tia::server {

void RequestTask::make(const Answer& answer, const std::atomic<bool>& closing,
                       const std::function<void()>& more) noexcept {
  try {
    make_answer(answer, closing, more);
  } catch (...) {
    failure = std::current_exception();
  }
}

void RequestTask::make_answer(const Answer& answer, const std::atomic<bool>& closing,
                              const std::function<void()>& more) {
  response = answer(request);
  if (closing) keep_alive = false;
  if (response.feed) return make_head();
  if (response.parts && request.is_http_1_0) gather_parts();
  if (!response.parts) {
    body_bytes = response.shared ? response.shared->size() : response.body.size();
    bytes = answer_bytes(response, request.is_head(), keep_alive);
    return;
  }
  if (response.parts_deadline.count() > 0) {
    {
      const std::lock_guard lock(mutex_);
      parts_deadline_ = response.parts_deadline;
    }
    more();
  }
  send_parts(more);
}

// HTTP/1.0 knows no chunks: there the connection's end is the body's.
void RequestTask::make_head() {
  keep_alive = keep_alive && !request.is_http_1_0;
  if (request.is_http_1_0) response.unsized = true;
  else response.parts = [](const SendPart&) {};
  bytes = answer_bytes(response, true, keep_alive);
  response.parts = nullptr;
}

// HTTP/1.0 knows no chunks.
void RequestTask::gather_parts() {
  std::size_t to_stay = 0;
  const auto next = [&](std::string_view part) { to_stay = response.body.append(part).size(); };
  const auto latest = [&](std::string_view part) {
    response.body.resize(to_stay);
    response.body += part;
  };
  std::exchange(response.parts, nullptr)({next, latest});
}

void RequestTask::send_parts(const std::function<void()>& more) {
  bool has_head = false;
  const TakeBytes take = [&](std::string_view bytes, Part part) {
    if (std::exchange(has_head, true)) return put(bytes, part, more);
    head_ = bytes;
    return true;
  };
  write_answer(response, request.is_head(), keep_alive, take);
  bytes = std::exchange(head_, {});  // of HEAD, whose parts nobody makes
}

bool RequestTask::put(std::string_view bytes, Part part, const std::function<void()>& more) {
  {
    std::unique_lock lock(mutex_);
    const auto may_go_on = [&] {
      const std::size_t waiting = parts_.size() - (part == Part::taken ? 0 : to_be_replaced_);
      return part == Part::latest || waiting < (part == Part::taken ? 1 : timeouts::most_parts) ||
             request.stop.stop_requested();
    };
    taken_.wait(lock, may_go_on);
    if (request.stop.stop_requested()) return false;
    if (part == Part::taken) return true;
    if (part == Part::latest) parts_.resize(parts_.size() - to_be_replaced_);
    in_parts_ = true;
    parts_.append(head_).append(bytes);
    body_bytes += head_.size() + bytes.size();
    to_be_replaced_ = part == Part::latest ? bytes.size() : 0;
    head_.clear();
  }
  more();
  return true;
}

std::string RequestTask::take_parts() {
  std::string parts;
  const std::lock_guard lock(mutex_);
  parts.swap(parts_);
  to_be_replaced_ = 0;
  taken_.notify_one();
  return parts;
}

void RequestTask::abandon() {
  const std::lock_guard lock(mutex_);
  stop.request_stop();
  taken_.notify_one();
}

std::chrono::milliseconds RequestTask::parts_deadline() {
  const std::lock_guard lock(mutex_);
  return parts_deadline_;
}

bool RequestTask::has_parts() {
  const std::lock_guard lock(mutex_);
  return in_parts_;
}

}  // namespace tia::server
