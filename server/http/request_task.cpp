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
  if (response.parts && request.is_http_1_0) gather_parts();
  if (!response.parts) {
    body_bytes = response.shared ? response.shared->size() : response.body.size();
    bytes = answer_bytes(response, request.is_head(), keep_alive);
    return;
  }
  try {
    const TakeBytes take = [&](std::string_view part) { return put(part, more); };
    write_answer(response, request.is_head(), keep_alive, take);
  } catch (...) {  // its head has been sent: all that is left is to break off
    is_cut = true;
  }
}

// HTTP/1.0 knows no chunks.
void RequestTask::gather_parts() {
  std::exchange(response.parts, nullptr)([&](std::string_view part) { response.body += part; });
}

bool RequestTask::put(std::string_view part, const std::function<void()>& more) {
  {
    std::unique_lock lock(mutex_);
    taken_.wait(lock, [&] {
      return parts_.size() < timeouts::most_parts || request.stop.stop_requested();
    });
    if (request.stop.stop_requested()) return false;
    in_parts_ = true;
    parts_.append(part);
    body_bytes += part.size();
  }
  more();
  return true;
}

std::string RequestTask::take_parts() {
  std::string parts;
  const std::lock_guard lock(mutex_);
  parts.swap(parts_);
  taken_.notify_one();
  return parts;
}

void RequestTask::abandon() {
  const std::lock_guard lock(mutex_);
  stop.request_stop();
  taken_.notify_one();
}

bool RequestTask::has_parts() {
  const std::lock_guard lock(mutex_);
  return in_parts_;
}

}  // namespace tia::server
