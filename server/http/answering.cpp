// The half of a connection that has to do with answers: who makes them, and what becomes of them.
#include <string_view>

#include "server/http/answer_writer.h"
#include "server/http/connection.h"
#include "server/http/error.h"
#include "server/http/timeouts.h"

namespace tia::server {
namespace {

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// What is said where there is no memory for other words.
constexpr std::string_view last_words =
    "HTTP/1.1 503 Service Unavailable\r\nContent-Type: application/problem+json\r\n"
    "Content-Length: 173\r\nCache-Control: no-store\r\nRetry-After: 1\r\nConnection: close\r\n"
    "X-Request-Id: unknown\r\n\r\n"
    R"({"type":"/problems/memory","title":"The server is short of memory","status":503,)"
    R"("detail":"there is no memory for the answer now; ask again or for less",)"
    R"("instance":"unknown"})";
static_assert(last_words.size() - last_words.find('{') == 173);

Request without_body(const Request& from) {
  Request to{from.method, from.target, from.headers, "", from.id, from.peer};
  to.trace = from.trace;
  to.arrived = from.arrived;
  to.key = from.key;
  to.caller = from.caller;
  return to;
}

}  // namespace

void Connection::begin(Request request) {
  request.peer = client_address(peer_, request.headers, context_.options.trusts_proxy);
  context_.application.identify(request);
  task_ = std::make_shared<RequestTask>(std::move(request));
  parts_due_ = {};
  task_->client = context_.options.share_of(task_->request.peer);
  task_->keep_alive = keep_alive_;
  account();
  const Application& application = context_.application;
  if (application.at_once(task_->request)) {
    task_->make(application.answer, context_.closing, [] {});
    hand_over(*task_);
  } else if (auto known = application.from_memory(task_->request)) {
    task_->make([&](const Request&) { return std::move(*known); }, context_.closing, [] {});
    hand_over(*task_);
  } else if (!context_.has_worker_for(task_->client)) {
    fail_turn(failure("busy", "all that may wait here does (option TIA_QUEUE)",
                      {{"Retry-After", std::to_string(application.retry_after())}}));
  } else {
    work();
  }
}

void Connection::work() {
  int& own = context_.at_work[task_->client];
  context_.workers.post([self = shared_from_this(), task = task_] {
    ServerContext& context = self->context_;
    task->make(context.application.answer, context.closing,
               [&] { context.tell([self] { self->pump(); }); });
    context.tell([self, task] { self->finish(task); });
  });
  --context_.free_workers;  // last: nothing is taken where memory for the rest is short
  ++own;
  enter(Phase::answering, context_.options.deadline);
}

// Sends the parts that have been made, while the client takes them.
void Connection::pump() {
  if (phase_ != Phase::answering) return;
  if (parts_due_ == Clock::time_point()) watch_parts(Clock::now());
  if (outbox_.empty()) proceed();
}

void Connection::finish(const std::shared_ptr<RequestTask>& task) {
  ++context_.free_workers;
  const auto own = context_.at_work.find(task->client);
  if (--own->second == 0) context_.at_work.erase(own);
  context_.last_work = Clock::now();
  if (task != task_ || phase_ != Phase::answering) return;  // nobody waits for it any more
  hand_over(*task);
  proceed();
}

// Sends what has been made, or tells why it is not: most likely there is no memory for it.
void Connection::hand_over(RequestTask& task) {
  try {
    if (task.failure) std::rethrow_exception(task.failure);
    outbox_.put(task.take_parts());
    deliver(task);
  } catch (...) {
    fail_turn(std::current_exception());
  }
}

void Connection::deliver(RequestTask& task) {
  context_.application.answered(
      {task.request, task.response, task.body_bytes, ms_since(task.request.arrived)});
  outbox_.put(std::move(task.bytes),
              task.response.shared);  // after what may fail: or a second answer would follow
  keep_alive_ = task.keep_alive;
  const std::shared_ptr<Feed> feed = std::move(task.response.feed);
  const bool is_chunked = !task.request.is_http_1_0;
  task_.reset();
  account();
  outbox_.begin();
  if (feed) return begin_feed(feed, is_chunked);
  enter(Phase::writing, timeouts::look);
  gone_ = 0;
  gone_at_ = since_;
}

// Answers the request in work with a problem, or ends its answer with one, unless there is no
// memory even for that.
void Connection::fail_turn(const std::exception_ptr& failure) {
  try {
    tell_failure(failure);
  } catch (...) {
    run_dry();
  }
}

// Whatever its worker does, which may still read the request.
void Connection::tell_failure(const std::exception_ptr& failure) {
  const std::shared_ptr<RequestTask> task = task_;
  task->abandon();
  // Its head has gone out: what is left is to break off, with a word where that is possible.
  if (task->has_parts()) return task->response.problem_part ? end_with(failure) : leave();
  RequestTask instead(without_body(task->request));
  instead.keep_alive = keep_alive_ && !context_.closing;
  instead.make(
      [&](const Request& request) { return context_.application.refuse(failure, request); },
      context_.closing, [] {});
  if (instead.failure) std::rethrow_exception(instead.failure);
  deliver(instead);
}

// Ends an answer in parts with what went wrong, and the connection with it: its worker may be at it
// yet, and is not heard any more.
void Connection::end_with(const std::exception_ptr& failure) {
  const std::shared_ptr<RequestTask> task = task_;
  const Response refusal = context_.application.refuse(failure, task->request);
  std::string end = task->take_parts();
  end += chunk_of(task->response.problem_part(refusal.body));
  outbox_.put(end.append(last_chunk));
  context_.application.answered(
      {task->request, task->response, task->body_bytes, ms_since(task->request.arrived)});
  keep_alive_ = false;
  task_.reset();
  account();
  outbox_.begin();
  enter(Phase::writing, timeouts::answer);
}

// Answers bytes that are no request. Where the next one begins is unknown: so the connection ends.
void Connection::refuse(const std::exception_ptr& failure) {
  task_ = std::make_shared<RequestTask>(without_body(reader_.request()));
  if (task_->request.id.empty()) task_->request.id = request_id("");
  task_->request.peer =
      client_address(peer_, task_->request.headers, context_.options.trusts_proxy);
  context_.application.identify(task_->request);
  keep_alive_ = false;
  fail_turn(failure);
}

// There is no memory for an answer: to close gives some back.
void Connection::run_dry() {
  const bool has_begun = !outbox_.empty() || (task_ && task_->has_parts());
  asio::error_code error;
  if (!has_begun) socket_.write_some(asio::buffer(last_words), error);
  close();
}

// The client has closed or is gone.
void Connection::leave() {
  const std::shared_ptr<RequestTask> task = task_;
  close();
  if (!task) return;
  Response none;
  none.status = Application::client_left;
  context_.application.answered({task->request, none, 0, ms_since(task->request.arrived)});
}

}  // namespace tia::server
