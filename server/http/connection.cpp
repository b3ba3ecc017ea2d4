#include "server/http/connection.h"

#include <linux/sockios.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <asio/post.hpp>
#include <new>
#include <utility>

#include "server/http/answer_writer.h"
#include "server/http/error.h"
#include "server/http/timeouts.h"

namespace tia::server {
namespace {

using asio::ip::tcp;
using State = RequestReader::State;

std::string address_of(const tcp::socket& socket) {
  asio::error_code error;
  const auto address = socket.remote_endpoint(error).address();
  if (error) return {};
  if (!address.is_v6() || !address.to_v6().is_v4_mapped()) return address.to_string();
  return asio::ip::make_address_v4(asio::ip::v4_mapped, address.to_v6()).to_string();
}

BodyLimits limits_of(const ServerContext& context) {
  BodyLimits limits(context.options.max_body_bytes, context.options.max_png_bytes);
  limits.own = context.application.body_limit;
  return limits;
}

bool would_block(const asio::error_code& error) {
  return error == asio::error::would_block || error == asio::error::try_again ||
         error == asio::error::interrupted;
}

}  // namespace

Connection::Connection(tcp::socket socket, ServerContext& context)
    : socket_(std::move(socket)),
      context_(context),
      peer_(address_of(socket_)),
      reader_(limits_of(context), context.application.long_body) {}

void Connection::start() {
  asio::error_code error;
  socket_.non_blocking(true, error);
  if (error) return close();                       // to read from it would keep all others waiting
  socket_.set_option(tcp::no_delay(true), error);  // else a round trip waits 40 ms for an ACK
  // Else the system takes megabytes for each client that does not read, until it has none left.
  socket_.set_option(tcp::socket::send_buffer_size(static_cast<int>(timeouts::most_at_once)),
                     error);
  enter(Phase::reading, context_.closing ? Clock::duration(timeouts::drained) : timeouts::head);
  attempt(&Connection::read);
}

void Connection::turn_away() {
  asio::error_code error;
  socket_.non_blocking(true, error);
  if (error) return close();
  refuse(failure("busy", "all connections are in use (option TIA_CONNECTIONS)",
                 {{"Retry-After", std::to_string(context_.application.retry_after())}}));
  proceed();
}

void Connection::enter(Phase phase, Clock::duration timeout) {
  phase_ = phase;
  since_ = Clock::now();
  due_ = since_ + timeout;
}

// ---- reading --------------------------------------------------------------------------------

void Connection::read() {
  asio::error_code error;
  const std::size_t size = socket_.read_some(asio::buffer(context_.scratch), error);
  if (error && !would_block(error)) return leave();
  if (phase_ == Phase::reading) taken_ = Clock::now();
  if (phase_ != Phase::lingering) reader_.feed({context_.scratch.data(), size});
  if (phase_ == Phase::reading && !queued_) return proceed();
  if (phase_ == Phase::lingering || reader_.unread() < timeouts::most_ahead) wait_readable();
}

void Connection::wait_readable() {
  const bool is_full = phase_ == Phase::reading && storing_ > 0;
  if (read_armed_ || is_full || phase_ == Phase::closed) return;
  socket_.async_wait(tcp::socket::wait_read, [self = shared_from_this()](asio::error_code error) {
    self->read_armed_ = false;
    // While an answer goes out, only whether it does tells that the client is there.
    if (self->phase_ == Phase::closed || self->phase_ == Phase::writing) return;
    if (error) return self->close();
    self->attempt(&Connection::read);
  });
  read_armed_ = true;
}

// Bytes of the answer that the system holds for the client.
std::size_t Connection::waiting_bytes() {
  int waiting = 0;
  ioctl(socket_.native_handle(), SIOCOUTQ, &waiting);
  return std::min(static_cast<std::size_t>(waiting), outbox_.sent());
}

// Does it, unless there is no memory for that.
void Connection::attempt(void (Connection::*step)()) {
  try {
    (this->*step)();
  } catch (const std::bad_alloc&) {
    run_dry();
  }
}

void Connection::proceed() { attempt(&Connection::go_on); }

// Goes on until something must be waited for, or it is others' turn.
void Connection::go_on() {
  for (;;) {
    if (!flush()) return;
    switch (phase_) {
      case Phase::reading:
        if (!take_request()) return wait_readable();
        break;
      case Phase::answering: return wait_readable();  // to see whether the client leaves
      case Phase::feeding:
        if (!take_fed()) return wait_readable();
        break;
      case Phase::writing:
        if (!keep_alive_) return linger();
        enter(Phase::reading, timeouts::idle);
        if (reader_.unread() > 0) return queue_up();
        break;
      case Phase::lingering:
      case Phase::closed: return;
    }
  }
}

// Lets all others have their turn first: who sends many requests ahead would else keep them waiting
// for all the answers.
void Connection::queue_up() {
  if (queued_) return;
  asio::post(context_.io, [self = shared_from_this()] {
    self->queued_ = false;
    if (self->phase_ == Phase::reading) self->proceed();
  });
  queued_ = true;
}

// Returns: false where more bytes must come first, or go.
bool Connection::take_request() {
  if (storing_ > 0) return false;
  try {
    const State before = reader_.state(), now = reader_.read();
    account();
    if (now == State::whole && !reader_.has_portion()) {
      keep_alive_ = reader_.keep_alive() && ++requests_ < timeouts::most_requests;
      begin(reader_.take());
      return true;
    }
    if (context_.holds_too_much() && held_ > timeouts::most_ahead)
      throw HttpError("busy", "too many requests with long bodies come at once",
                      {{"Retry-After", std::to_string(context_.application.retry_after())}});
    set_timeout(before);
    if (reader_.has_portion()) store();
    if (!reader_.wants_continue()) return false;
    outbox_.put("HTTP/1.1 100 Continue\r\n\r\n");
  } catch (...) {
    refuse(std::current_exception());
  }
  return true;
}

void Connection::set_timeout(State before) {
  const State now = reader_.state();
  if (now == State::idle && context_.closing && requests_ > 0) return linger();
  if (before == State::idle && now != before && requests_ > 0)
    enter(Phase::reading, timeouts::head);
  if (now == State::body) {
    if (before != now) enter(Phase::reading, timeouts::body);
    // Who has sent faster than the slowest rate may not pause longer for that: the deadline is at
    // most `body` from now.
    due_ = std::min(since_ + timeouts::at_slowest_rate(reader_.body_bytes()), Clock::now()) +
           timeouts::body;
  }
}

void Connection::account() {
  const std::size_t held =
      reader_.held() + storing_ + outbox_.held() + (task_ ? task_->request.body.capacity() : 0);
  if (held != held_)
    context_.hold(static_cast<std::ptrdiff_t>(held) - static_cast<std::ptrdiff_t>(held_));
  held_ = held;
}

// ---- writing --------------------------------------------------------------------------------

// Sends what there is to send. Returns: false where the rest must wait, or the client is gone.
bool Connection::flush() {
  do {
    const std::size_t before = outbox_.sent();
    const asio::error_code error = outbox_.send(socket_);
    if (outbox_.sent() != before) taken_ = Clock::now();
    if (error) {
      account();
      if (would_block(error)) wait_writable();
      else leave();
      return false;
    }
    if (phase_ == Phase::answering) outbox_.put(task_->take_parts());
  } while (!outbox_.empty());
  account();
  return true;
}

void Connection::wait_writable() {
  if (write_armed_) return;
  socket_.async_wait(tcp::socket::wait_write, [self = shared_from_this()](asio::error_code error) {
    self->write_armed_ = false;
    if (self->phase_ == Phase::closed) return;
    if (error) return self->close();
    self->proceed();
  });
  write_armed_ = true;
}

// ---- ending ---------------------------------------------------------------------------------

bool Connection::is_stuck(Clock::time_point now) const {
  const bool holds =
      phase_ == Phase::writing || (phase_ == Phase::reading && held_ > timeouts::most_ahead);
  return holds && now - std::max(since_, taken_) > timeouts::stuck;
}

void Connection::tick(Clock::time_point now) {
  if (now < due_) return;
  try {
    cut_off(now);
  } catch (const std::bad_alloc&) {
    run_dry();
  }
}

void Connection::cut_off(Clock::time_point now) {
  switch (phase_) {
    case Phase::reading:
      if (reader_.state() == State::idle) return linger();
      refuse(lateness());
      return proceed();
    case Phase::answering:
      if (now < parts_due_) return watch_parts(now);
      fail_turn(failure("timeout",
                        "no answer within " + std::to_string(context_.options.deadline.count()) +
                            " ms, the time in the queue included (option TIA_DEADLINE_MS)",
                        {{"Retry-After", std::to_string(context_.application.retry_after())}}));
      return proceed();
    case Phase::feeding: return watch_feed(now);
    case Phase::writing: return watch_taking(now);
    case Phase::lingering:
    case Phase::closed: return close();
  }
}

// Who has taken bytes faster than the slowest rate may not pause longer for that: an answer's limit
// is at most `answer` from when we last saw some of it gone.
void Connection::watch_taking(Clock::time_point now) {
  const std::size_t gone = outbox_.sent() - waiting_bytes();
  if (gone > gone_) gone_at_ = now;
  gone_ = gone;
  const auto end = std::min(since_ + timeouts::at_slowest_rate(gone_), gone_at_) + timeouts::answer;
  if (now >= end) return close();
  due_ = std::min(end, now + timeouts::look);
}

// Parts that may take long go on as long as their client keeps up with the slowest rate: who does
// not holds up work whose place others wait for.
void Connection::watch_parts(Clock::time_point now) {
  const bool begins = parts_due_ == Clock::time_point();
  if (begins) {
    const auto deadline = task_->parts_deadline();
    if (deadline.count() == 0) return;
    parts_due_ = since_ + deadline;
  }
  const std::size_t gone = outbox_.sent() - waiting_bytes();
  const std::size_t least = timeouts::slowest_rate * timeouts::look.count();
  if (begins || outbox_.empty() || gone >= gone_ + least) gone_at_ = now;
  gone_ = gone;
  if (now - gone_at_ >= timeouts::answer) return leave();
  due_ = std::min(parts_due_, now + timeouts::look);
}

void Connection::retire() {
  if (phase_ == Phase::feeding) {
    keep_alive_ = false;
    end_feed(is_chunked_ ? std::string(last_chunk) : "");
    return proceed();
  }
  if (phase_ != Phase::reading || reader_.state() != State::idle || queued_) return;
  if (requests_ > 0) linger();
  else due_ = Clock::now() + timeouts::drained;
}

void Connection::give_up() {
  if (phase_ == Phase::answering) {
    fail_turn(failure("draining", "the server goes down; ask again", {{"Retry-After", "1"}}));
    proceed();
  } else if (phase_ == Phase::reading) {
    linger();
  } else {
    close();
  }
}

// Lets the client read what was sent: to close on one that still writes would reset the connection
// and lose the answer on its way.
void Connection::linger() {
  asio::error_code error;
  socket_.shutdown(tcp::socket::shutdown_send, error);
  enter(Phase::lingering, timeouts::linger);
  wait_readable();
}

void Connection::close() {
  if (phase_ == Phase::closed) return;
  phase_ = Phase::closed;
  context_.hold(-static_cast<std::ptrdiff_t>(std::exchange(held_, 0)));
  drop_feed();
  if (task_) task_->abandon();
  task_.reset();
  asio::error_code error;
  socket_.close(error);
  context_.connections.erase(shared_from_this());
  context_.open = static_cast<int>(context_.connections.size());
}

}  // namespace tia::server
