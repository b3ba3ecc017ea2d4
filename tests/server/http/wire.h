// Servers with any application, and clients that see every byte and choose how slowly they read.
#pragma once

#include <netdb.h>

#include <atomic>
#include <future>
#include <memory>
#include <string>
#include <string_view>

#include "tests/server/http/request_forms.h"
#include "tests/server/socket_support.h"

namespace tia::test {

inline double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

inline HttpOptions any_port() { return {.host = "127.0.0.1", .port = 0}; }

/// Serving: an application of the test's own, served.
class Serving {
 public:
  explicit Serving(Application application, HttpOptions options = any_port())
      : http_(std::move(options), std::move(application)) {}
  ~Serving() { stop(milliseconds(0), milliseconds(0)); }

  int port() const { return http_.port(); }
  int connections() const { return http_.connections(); }
  void stop(milliseconds delay, milliseconds limit) { http_.stop(delay, limit); }
  /// Whether run() returns in time.
  bool ends(milliseconds patience = seconds(20)) {
    return running_.wait_for(patience) == std::future_status::ready;
  }

 private:
  HttpServer http_;
  std::future<void> running_ = std::async(std::launch::async, [this] { http_.run(); });
};

/// An application that answers every request on a worker.
inline Application answering(std::function<Response(const Request&)> answer) {
  Application application;
  application.answer = std::move(answer);
  return application;
}
inline Response text(std::string body) {
  return {.status = 200, .content_type = "text/plain", .body = std::move(body)};
}

/// Latch: closed until it is opened.
class Latch {
 public:
  void open() { opened_.set_value(); }
  void wait() { opening_.wait(); }

 private:
  std::promise<void> opened_;
  std::shared_future<void> opening_ = opened_.get_future().share();
};

/// Wire: a plain connection, byte by byte.
class Wire {
 public:
  /// receive_buffer: the system's, unless told; a small one makes a client that does not read felt.
  explicit Wire(int port, int receive_buffer = 0, const char* address = "127.0.0.1") {
    addrinfo hints{}, *found = nullptr;
    hints.ai_flags = AI_NUMERICHOST | AI_NUMERICSERV;
    hints.ai_socktype = SOCK_STREAM;
    if (::getaddrinfo(address, std::to_string(port).c_str(), &hints, &found) != 0)
      throw std::runtime_error(std::string("no address ") + address);
    const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owned(found, ::freeaddrinfo);
    socket_ = ::socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (receive_buffer > 0)
      ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
    if (::connect(socket_, found->ai_addr, found->ai_addrlen) != 0) {
      ::close(socket_);
      throw std::runtime_error("cannot connect to port " + std::to_string(port));
    }
  }
  ~Wire() { leave(); }
  Wire(const Wire&) = delete;
  Wire& operator=(const Wire&) = delete;

  /// Whether all was sent, and not less because the server has closed.
  bool send(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (sent <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
  }
  /// Sends what the system takes at once. Returns: how many bytes.
  ssize_t offer(std::string_view bytes) {
    return ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  }
  int descriptor() const { return socket_; }
  void get(const std::string& target) { send("GET " + target + " HTTP/1.1\r\nHost: x\r\n\r\n"); }
  /// No more will be sent.
  void finish() { ::shutdown(socket_, SHUT_WR); }
  void leave() {
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
  }
  bool readable(milliseconds wait = milliseconds(0)) const {
    pollfd poll{socket_, POLLIN, 0};
    return ::poll(&poll, 1, static_cast<int>(wait.count())) > 0;
  }
  /// Reads on until the bytes end with the mark, or the server closes, and takes them.
  std::string until(std::string_view mark) {
    std::string taken;
    while (!taken.ends_with(mark)) {
      const std::string more = read(1);
      if (more.empty()) break;
      taken += more;
    }
    return taken;
  }
  /// All bytes until the server closes. Errors: std::runtime_error if it does not in time.
  std::string rest(milliseconds patience = seconds(60)) {
    std::string taken;
    for (std::string more = read(1 << 16, patience); !more.empty(); more = read(1 << 16, patience))
      taken += more;
    return taken;
  }
  /// So many bytes at most; "" = the server has closed.
  std::string read(std::size_t most, milliseconds patience = seconds(60)) {
    if (!readable(patience)) throw std::runtime_error("neither bytes nor a close");
    std::string bytes(most, '\0');
    const ssize_t n = ::recv(socket_, bytes.data(), most, 0);
    bytes.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
    return bytes;
  }

 private:
  int socket_ = -1;
};

inline int status_of(const std::string& answer) {
  const auto space = answer.find(' ');
  return space == answer.npos ? 0 : std::stoi(answer.substr(space));
}
inline std::string body_of(const std::string& answer) {
  const auto end = answer.find("\r\n\r\n");
  return end == answer.npos ? "" : answer.substr(end + 4);
}

}  // namespace tia::test
