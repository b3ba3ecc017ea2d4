// The addresses at which clients come in.
#pragma once

#include <asio/ip/tcp.hpp>
#include <asio/steady_timer.hpp>
#include <functional>
#include <list>
#include <string>
#include <vector>

namespace tia::server {

/// Acceptors: every address that a host's name stands for, all on one port. Lives on the
/// connections' thread.
class Acceptors {
 public:
  using Welcome = std::function<void(asio::ip::tcp::socket)>;

  /// Listens from now on. `make_room` is called where a client has come and the system has no
  /// descriptor left for it.
  /// Errors: std::runtime_error that names host and port, and what the system says of them.
  Acceptors(asio::io_context& io, const std::string& host, int port, Welcome welcome,
            std::function<void()> make_room);
  /// The port listened on, chosen by the system where 0 was asked for.
  int port() const { return port_; }
  /// Lets clients in. May be called again where an exception has come between.
  void accept_all();
  /// Closes. Returns: those who had come before.
  std::vector<asio::ip::tcp::socket> close();

 private:
  struct Acceptor {
    explicit Acceptor(asio::io_context& io) : socket(io), resting(io) {}
    asio::ip::tcp::acceptor socket;
    asio::steady_timer resting;  // when it cannot let anyone in
    int calls = 0;               // of accept(): only the last goes on
  };
  void open(const asio::ip::tcp::endpoint& endpoint);
  void accept(Acceptor& acceptor);

  asio::io_context& io_;
  Welcome welcome_;
  std::function<void()> make_room_;
  std::list<Acceptor> acceptors_;
  int port_;
};

}  // namespace tia::server
