// One request's way through a worker: what the connection gives it and what it gives back.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <stop_token>
#include <string>

#include "server/http/answer_writer.h"
#include "server/http/message.h"

namespace tia::server {

/// RequestTask: a request in work. The worker owns `response` and `bytes` until it is done, then
/// the connection does; the parts of an answer pass between them under a lock.
class RequestTask {
 public:
  explicit RequestTask(Request asked) : request(std::move(asked)) {
    request.stop = stop.get_token();
  }

  std::stop_source stop;
  Request request;
  std::string client;  ///< whose share of the workers it takes
  bool keep_alive = true;
  Response response;
  std::size_t body_bytes = 0;
  /// The whole answer, but for a body that others have too, or the rest of one that goes in parts.
  std::string bytes;
  std::exception_ptr failure;  ///< what was thrown in the answer's place, or among its parts

  using Answer = std::function<Response(const Request&)>;
  /// Worker: makes the answer, or says what failed. `more` is called whenever a part waits to be
  /// sent.
  void make(const Answer& answer, const std::atomic<bool>& closing,
            const std::function<void()>& more) noexcept;
  /// Connection: the parts that wait, so that the worker may go on.
  std::string take_parts();
  /// Connection: nobody waits for the answer any more.
  void abandon();
  /// Whether the answer goes in parts, and its head has been made.
  bool has_parts();
  /// What its parts may take, where that is longer than answers may; else 0.
  std::chrono::milliseconds parts_deadline();

 private:
  void make_answer(const Answer& answer, const std::atomic<bool>& closing,
                   const std::function<void()>& more);
  void make_head();
  void gather_parts();
  void send_parts(const std::function<void()>& more);
  bool put(std::string_view bytes, Part part, const std::function<void()>& more);

  std::mutex mutex_;
  std::condition_variable taken_;
  std::string head_;                // until the first part is there
  std::string parts_;               // that wait to be sent
  std::size_t to_be_replaced_ = 0;  // of these, at their end
  bool in_parts_ = false;
  std::chrono::milliseconds parts_deadline_{};
};

}  // namespace tia::server
