// The half of a connection that has to do with answers: who makes them, and what becomes of them.
#include <string_view>

#include "server/http/answer_writer.h"
#include "server/http/connection.h"
#include "server/http/error.h"
#include "server/http/patience.h"

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
  return to;
}

}  // namespace

void Connection::begin(Request request) {
  request.peer = client_address(peer_, request.headers, house_.options.trusts_proxy);
  turn_ = std::make_shared<Turn>(std::move(request));
  turn_->client = house_.options.share_of(turn_->request.peer);
  turn_->keep_alive = keep_alive_;
  account();
  const Application& application = house_.application;
  if (application.at_once(turn_->request)) {
    turn_->make(application.answer, house_.closing, [] {});
    hand_over(*turn_);
  } else if (auto known = application.from_memory(turn_->request)) {
    turn_->make([&](const Request&) { return std::move(*known); }, house_.closing, [] {});
    hand_over(*turn_);
  } else if (!house_.has_worker_for(turn_->client)) {
    fail_turn(failure("busy", "all that may wait here does (option TIA_QUEUE)",
                      {{"Retry-After", std::to_string(application.retry_after())}}));
  } else {
    work();
  }
}

void Connection::work() {
  int& own = house_.at_work[turn_->client];
  house_.workers.post([self = shared_from_this(), turn = turn_] {
    House& house = self->house_;
    turn->make(house.application.answer, house.closing,
               [&] { house.tell([self] { self->pump(); }); });
    house.tell([self, turn] { self->finish(turn); });
  });
  --house_.free_workers;  // last: nothing is taken where memory for the rest is short
  ++own;
  enter(Phase::answering, house_.options.deadline);
}

// Sends the parts that have been made, while the client takes them.
void Connection::pump() {
  if (phase_ == Phase::answering && outbox_.empty()) proceed();
}

void Connection::finish(const std::shared_ptr<Turn>& turn) {
  ++house_.free_workers;
  const auto own = house_.at_work.find(turn->client);
  if (--own->second == 0) house_.at_work.erase(own);
  house_.last_work = Clock::now();
  if (turn != turn_ || phase_ != Phase::answering) return;  // nobody waits for it any more
  if (turn->is_cut) return leave();
  hand_over(*turn);
  proceed();
}

// Sends what has been made, or tells why it is not: most likely there is no memory for it.
void Connection::hand_over(Turn& turn) {
  try {
    if (turn.failure) std::rethrow_exception(turn.failure);
    outbox_.put(turn.take_parts());
    deliver(turn);
  } catch (...) {
    fail_turn(std::current_exception());
  }
}

void Connection::deliver(Turn& turn) {
  house_.application.answered(
      {turn.request, turn.response, turn.body_bytes, ms_since(turn.request.arrived)});
  outbox_.put(std::move(turn.bytes),
              turn.response.shared);  // after what may fail: or a second answer would follow
  keep_alive_ = turn.keep_alive;
  turn_.reset();
  account();
  outbox_.begin();
  enter(Phase::writing, patience::answer);
}

// Answers the request in work with a problem, unless there is no memory even for that.
void Connection::fail_turn(const std::exception_ptr& failure) {
  try {
    tell_failure(failure);
  } catch (...) {
    run_dry();
  }
}

// Whatever its worker does, which may still read the request.
void Connection::tell_failure(const std::exception_ptr& failure) {
  const std::shared_ptr<Turn> turn = turn_;
  turn->abandon();
  if (turn->has_parts()) return leave();  // its head has gone out: all that is left is to break off
  Turn instead(without_body(turn->request));
  instead.keep_alive = keep_alive_ && !house_.closing;
  instead.make([&](const Request& request) { return house_.application.refuse(failure, request); },
               house_.closing, [] {});
  if (instead.failure) std::rethrow_exception(instead.failure);
  deliver(instead);
}

// Answers bytes that are no request. Where the next one begins is unknown: so the connection ends.
void Connection::refuse(const std::exception_ptr& failure) {
  turn_ = std::make_shared<Turn>(without_body(reader_.request()));
  if (turn_->request.id.empty()) turn_->request.id = request_id("");
  turn_->request.peer = client_address(peer_, turn_->request.headers, house_.options.trusts_proxy);
  keep_alive_ = false;
  fail_turn(failure);
}

// There is no memory for an answer: to close gives some back.
void Connection::run_dry() {
  const bool has_begun = !outbox_.empty() || (turn_ && turn_->has_parts());
  asio::error_code error;
  if (!has_begun) socket_.write_some(asio::buffer(last_words), error);
  close();
}

// The client has closed or is gone.
void Connection::leave() {
  const std::shared_ptr<Turn> turn = turn_;
  close();
  if (!turn) return;
  Response none;
  none.status = Application::client_left;
  house_.application.answered({turn->request, none, 0, ms_since(turn->request.arrived)});
}

}  // namespace tia::server
