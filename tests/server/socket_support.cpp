#include "tests/server/socket_support.h"

#include <httplib.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <utility>

#include "tests/server/contract/contract.h"

#include "server/contract/problem.h"

namespace tia::test {

bool eventually(const std::function<bool()>& ask, Clock::duration timeout) {
  const auto deadline = Clock::now() + timeout;
  while (!ask()) {
    if (Clock::now() > deadline) return false;
    std::this_thread::sleep_for(milliseconds(1));
  }
  return true;
}

Server::Server() : Server(HttpOptions{.host = "127.0.0.1", .port = 0}) {}
Server::Server(HttpOptions options)
    : host_(read_config({{"hosts", "*", ""}})),
      http_(std::move(options),
            {.answer = [this](const Request& request) { return host_.ask(request); },
             .refuse = problem_response,
             .at_once = is_answered_at_once}),
      running_([this] { http_.run(); }) {}
Server::~Server() {
  http_.stop();
  running_.join();
}
httplib::Client Server::client() const {
  httplib::Client client("127.0.0.1", port());
  client.set_keep_alive(true);
  client.set_tcp_nodelay(true);
  client.set_read_timeout(20);
  return client;
}

Server& shared_server() {
  static Server shared;
  return shared;
}

Response plain(const std::string& method, const std::string& target,
               const httplib::Result& result) {
  if (!result) throw std::runtime_error("no answer: " + httplib::to_string(result.error()));
  Response response{.status = result->status,
                    .content_type = result->get_header_value("Content-Type"),
                    .body = result->body};
  response.headers.assign(result->headers.begin(), result->headers.end());
  expect_allowed({method, target, {}, "", ""}, response);
  return response;
}

// ---- Connection -----------------------------------------------------------------------------

Connection::Connection(int port, bool judged)
    : witness_(judged ? port : 0), socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(static_cast<std::uint16_t>(port));
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(socket_, reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0) {
    ::close(socket_);
    throw std::runtime_error("cannot connect to port " + std::to_string(port));
  }
}
Connection::~Connection() { ::close(socket_); }

void Connection::send(std::string_view bytes) {
  witness_.sent(bytes);
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent <= 0) return;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
}
void Connection::finish() { ::shutdown(socket_, SHUT_WR); }

bool Connection::readable(milliseconds wait) const {
  pollfd poll{socket_, POLLIN, 0};
  return ::poll(&poll, 1, static_cast<int>(wait.count())) > 0;
}
Response Connection::receive() {
  for (;;) {
    if (auto response = take_answer(bytes_)) return std::move(*response);
    if (more()) continue;
    if (!bytes_.empty()) throw std::runtime_error("cut: " + bytes_.substr(0, 1000));
    return {.status = 0, .content_type = "", .body = ""};
  }
}
bool Connection::closed() { return bytes_.empty() && !more(); }

// Reads on. Returns: false at the end.
bool Connection::more() {
  if (!readable(seconds(20))) throw std::runtime_error("neither an answer nor a close");
  char buffer[1 << 16];
  const ssize_t n = ::recv(socket_, buffer, sizeof buffer, 0);
  if (n <= 0) return false;
  bytes_.append(buffer, static_cast<std::size_t>(n));
  witness_.received({buffer, static_cast<std::size_t>(n)});
  return true;
}

Response exchange(int port, std::string_view request) {
  Connection connection(port);
  connection.send(request);
  return connection.receive();
}

}  // namespace tia::test
