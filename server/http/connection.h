// One client's connection: bytes in, requests, answers, bytes out, each in its time. Lives on the
// server's one connection thread; only the answers are made elsewhere.
#pragma once

#include <asio/ip/tcp.hpp>
#include <exception>
#include <memory>
#include <string>

#include "server/http/outbox.h"
#include "server/http/request_reader.h"
#include "server/http/request_task.h"
#include "server/http/server_context.h"

namespace tia::server {

class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(asio::ip::tcp::socket socket, ServerContext& context);

  void start();
  /// Cuts off what has taken too long.
  void tick(Clock::time_point now);
  /// Closes once nothing is under way.
  void retire();
  /// Answers a request that is still in work with 503: the server goes down.
  void give_up();
  void close();

  /// Answers with 429, whatever is asked: there is no room.
  void turn_away();

  /// Whether it holds an answer that its client has not taken yet.
  bool is_stalled() const { return phase_ == Phase::writing; }
  /// Whether its client has taken nothing of an answer, or sent nothing of a long body, for so long
  /// that it hardly will.
  bool is_stuck(Clock::time_point now) const;
  /// Whether no whole request is lost by closing.
  bool waits_for_client() const {
    return (phase_ == Phase::reading && !queued_) || phase_ == Phase::lingering;
  }
  /// Whether its client has sent further requests before the last one's answer.
  bool is_queued() const { return phase_ == Phase::reading && queued_; }
  /// Since when it waits, reads, works or writes.
  Clock::time_point since() const { return since_; }

 private:
  enum class Phase { reading, answering, feeding, writing, lingering, closed };

  void enter(Phase phase, Clock::duration timeout);
  void attempt(void (Connection::*step)());
  void proceed();
  void go_on();
  void queue_up();
  bool take_request();
  void set_timeout(RequestReader::State before);
  void store();
  void go_on_reading(const std::exception_ptr& failure);
  std::exception_ptr lateness() const;
  void begin(Request request);
  void work();
  void pump();
  void finish(const std::shared_ptr<RequestTask>& task);
  void hand_over(RequestTask& task);
  void deliver(RequestTask& task);
  void begin_feed(std::shared_ptr<Feed> feed, bool is_chunked);
  bool take_fed();
  void end_feed(std::string last);
  void watch_feed(Clock::time_point now);
  void drop_feed();
  void refuse(const std::exception_ptr& failure);
  void fail_turn(const std::exception_ptr& failure);
  void tell_failure(const std::exception_ptr& failure);
  void end_with(const std::exception_ptr& failure);
  void cut_off(Clock::time_point now);
  void watch_taking(Clock::time_point now);
  void watch_parts(Clock::time_point now);
  void leave();
  bool flush();
  void linger();
  void run_dry();
  void wait_readable();
  void wait_writable();
  void read();
  std::size_t waiting_bytes();
  void account();

  asio::ip::tcp::socket socket_;
  ServerContext& context_;
  std::string peer_;
  RequestReader reader_;
  Phase phase_ = Phase::reading;
  Clock::time_point since_, due_;
  Clock::time_point stored_from_;      // when the writer was last given something
  Clock::time_point taken_;            // when the client last took bytes, or sent some
  std::shared_ptr<RequestTask> task_;  // the request in work
  std::shared_ptr<Feed> feed_;         // of an answer whose body comes by and by
  bool is_chunked_ = true;             // that body
  Outbox outbox_;
  std::size_t storing_ = 0;    // bytes of a long body that are being put away
  std::size_t gone_ = 0;       // bytes of an answer that the client's system had, at the last look
  Clock::time_point gone_at_;  // when they were last more than before
  Clock::time_point parts_due_;  // of an answer whose parts may take longer than answers; else none
  std::size_t held_ = 0;         // what we have told the context that we hold
  std::size_t requests_ = 0;
  bool keep_alive_ = true;
  bool read_armed_ = false, write_armed_ = false;
  bool queued_ = false;  // its turn comes after all others'
};

}  // namespace tia::server
