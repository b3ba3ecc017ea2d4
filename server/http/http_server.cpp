#include "server/http/http_server.h"

#include <httplib.h>
#include <sys/resource.h>
#include <time.h>

#include <algorithm>
#include <asio/steady_timer.hpp>
#include <new>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "server/http/acceptors.h"
#include "server/http/answer_writer.h"
#include "server/http/connection.h"

namespace tia::server {
namespace {

using asio::ip::tcp;
using std::chrono::milliseconds;

constexpr milliseconds tick{20};

// Every connection is a descriptor, and a few are ours: as many as the system lets us have.
void allow_descriptors(int connections) {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  const rlim_t wanted = static_cast<rlim_t>(connections) + 64;
  if (limit.rlim_cur >= wanted) return;
  limit.rlim_cur = std::min(wanted, limit.rlim_max);
  setrlimit(RLIMIT_NOFILE, &limit);
  if (limit.rlim_cur < wanted)
    throw std::runtime_error("option TIA_CONNECTIONS: got " + std::to_string(connections) +
                             ", allowed: at most " + std::to_string(limit.rlim_cur - 64) +
                             " under this system's limit of open files");
}

}  // namespace

class HttpServer::Listener {
 public:
  Listener(HttpOptions options, Application application)
      : context_(std::move(options), std::move(application)),
        acceptors_(
            context_.io, context_.options.host, context_.options.port,
            [this](tcp::socket socket) { welcome(std::move(socket)); }, [this] { make_room(); }) {
    allow_descriptors(context_.options.connections);
    tzset();         // reads the zone's file, which strftime would do at the first answer
    Response first;  // at which the library makes tables: by no two threads at once
    static_cast<void>(answer_bytes(first, false, false));
  }
  ~Listener() { context_.join(); }

  int port() const { return acceptors_.port(); }
  int connections() const { return context_.open; }

  void run() {
    while (!has_run()) std::this_thread::sleep_for(timeouts::memory);
    context_.join();
  }

  void stop(milliseconds delay, milliseconds limit) {
    context_.tell([this, delay, limit] {
      if (stopping_) return;
      stopping_ = Stopping{Clock::now() + delay, limit};
      wait_to_close();
    });
  }

 private:
  struct Stopping {
    Clock::time_point at;
    milliseconds limit;
  };

  bool has_run();
  bool has_resumed();
  void welcome(tcp::socket socket);
  bool make_room();
  template <class Which>
  bool close_longest(Which which);
  void give_back(Clock::time_point now);
  void wait_to_close();
  void close_acceptors();
  void keep_time();
  template <class Then>
  void after(asio::steady_timer& timer, Clock::duration time, Then then) {
    timer.expires_after(time);
    timer.async_wait([then](asio::error_code error) {
      if (!error) then();
    });
  }
  template <class Action>
  void for_each_connection(Action action) {  // which may close and so erase it
    const auto all = std::vector(context_.connections.begin(), context_.connections.end());
    for (const auto& connection : all) action(*connection);
  }

  ServerContext context_;
  Acceptors acceptors_;
  asio::steady_timer ticking_{context_.io}, closing_{context_.io};
  std::optional<Stopping> stopping_;
  bool keeps_time_ = false, is_shut_ = false;
};

// Returns: false where memory ran out before all was done.
bool HttpServer::Listener::has_run() {
  const bool resumed = has_resumed();
  try {
    if (resumed) context_.io.run();
    else context_.io.run_for(timeouts::memory);  // what can be done meanwhile
    return resumed;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

// Sets going what all else hangs on, wherever it was interrupted. The connections' timeouts do
// the same for them. Returns: false where there is no memory for it.
bool HttpServer::Listener::has_resumed() {
  context_.io.restart();
  try {
    acceptors_.accept_all();
    if (stopping_ && !is_shut_) wait_to_close();
    keep_time();
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

void HttpServer::Listener::welcome(tcp::socket socket) {
  const auto is_full = [this] {
    return static_cast<int>(context_.connections.size()) >= context_.options.connections;
  };
  while (is_full() && make_room()) {  // those who were turned away take places, too, for a while
  }
  const bool has_room = !is_full();
  const auto connection = std::make_shared<Connection>(std::move(socket), context_);
  context_.connections.insert(connection);
  context_.open = static_cast<int>(context_.connections.size());
  if (has_room) connection->start();
  else connection->turn_away();
  keep_time();
}

// Closes the connection that has waited longest for its client: one in earnest asks at once, and
// takes its answer. At last it may be one that asks without end, whose last answer it has.
// Returns: false where a request is under way on all of them.
bool HttpServer::Listener::make_room() {
  const auto now = Clock::now();
  return close_longest([](const Connection& each) { return each.waits_for_client(); }) ||
         close_longest([now](const Connection& each) { return each.is_stuck(now); }) ||
         close_longest([](const Connection& each) { return each.is_queued(); });
}

// Closes that one of those connections that has been so for longest. Returns: false without any.
template <class Which>
bool HttpServer::Listener::close_longest(Which which) {
  std::shared_ptr<Connection> longest;
  for (const auto& each : context_.connections)
    if (which(*each) && (!longest || each->since() < longest->since())) longest = each;
  if (longest) longest->close();
  return longest != nullptr;
}

// Tells the application once that there has been nothing to do for a while.
void HttpServer::Listener::give_back(Clock::time_point now) {
  const bool at_work = context_.free_workers < context_.options.workers;
  if (at_work || !context_.last_work || now - *context_.last_work < timeouts::rest) return;
  context_.last_work.reset();
  context_.application.rested();
}

// One clock for all connections, while there are any.
void HttpServer::Listener::keep_time() {
  if (context_.closing && context_.connections.empty())
    closing_.cancel();  // all is done: run() ends
  const bool idle = context_.connections.empty() && !context_.last_work;
  if (keeps_time_ || idle || (context_.closing && context_.connections.empty())) return;
  after(ticking_, tick, [this] {
    keeps_time_ = false;
    const auto now = Clock::now();
    for_each_connection([&](Connection& connection) { connection.tick(now); });
    // Who takes an answer goes on as long as there are others whose client does nothing.
    while (context_.holds_too_much() &&
           (close_longest([now](auto& each) { return each.is_stuck(now); }) ||
            close_longest([](auto& each) { return each.is_stalled(); }))) {
    }
    give_back(now);
    keep_time();
  });
  keeps_time_ = true;
}

void HttpServer::Listener::wait_to_close() {
  after(closing_, std::max(stopping_->at - Clock::now(), Clock::duration(0)),
        [this] { close_acceptors(); });
}

void HttpServer::Listener::close_acceptors() {
  context_.closing = true;
  for (tcp::socket& socket : acceptors_.close()) welcome(std::move(socket));
  for_each_connection([](Connection& connection) { connection.retire(); });
  after(closing_, stopping_->limit,
        [this] { for_each_connection([](Connection& connection) { connection.give_up(); }); });
  is_shut_ = true;
  keep_time();
}

HttpServer::HttpServer(HttpOptions options, Application application)
    : listener_(std::make_unique<Listener>(std::move(options), std::move(application))) {}
HttpServer::~HttpServer() = default;
int HttpServer::port() const { return listener_->port(); }
int HttpServer::connections() const { return listener_->connections(); }
void HttpServer::run() { listener_->run(); }
void HttpServer::stop(milliseconds delay, milliseconds limit) { listener_->stop(delay, limit); }

bool answers(const std::string& host, int port, const std::string& path) {
  httplib::Client client(host, port);
  client.set_connection_timeout(2);
  client.set_read_timeout(2);
  const auto response = client.Get(path);
  return response && response->status == 200;
}

}  // namespace tia::server
