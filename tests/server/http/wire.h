// Servers with any application, and clients that see every byte and choose how slowly they read.
#pragma once

#include <poll.h>
#include <sys/types.h>

#include <functional>
#include <future>
#include <string>
#include <string_view>

#include "tests/server/http/request_forms.h"
#include "tests/server/socket_support.h"

namespace tia::test {

/// A request of the page, in the fewest words.
inline const std::string plain_get = "GET / HTTP/1.1\r\nHost: x\r\n\r\n";

double ms_since(Clock::time_point start);

HttpOptions any_port();

/// Serving: an application of the test's own, served.
class Serving {
 public:
  explicit Serving(Application application, HttpOptions options = any_port());
  ~Serving();

  int port() const { return http_.port(); }
  int connections() const { return http_.connections(); }
  void stop(milliseconds delay, milliseconds limit) { http_.stop(delay, limit); }
  /// Whether run() returns in time.
  bool ends(milliseconds timeout = seconds(20));

 private:
  HttpServer http_;
  std::future<void> running_;
};

/// An application that answers every request on a worker.
Application answering(std::function<Response(const Request&)> answer);
Response text(std::string body);

/// Latch: closed until it is opened.
class Latch {
 public:
  Latch();
  ~Latch();
  void open();
  void wait();

 private:
  std::promise<void> opened_;
  std::shared_future<void> opening_;
};

/// Wire: a plain connection, byte by byte.
class Wire {
 public:
  /// receive_buffer: the system's, unless told; a small one makes a client that does not read felt.
  explicit Wire(int port, int receive_buffer = 0, const char* address = "127.0.0.1");
  ~Wire() { leave(); }
  Wire(const Wire&) = delete;
  Wire& operator=(const Wire&) = delete;

  /// Whether all was sent, and not less because the server has closed.
  bool send(std::string_view bytes);
  /// Sends what the system takes at once. Returns: how many bytes.
  ssize_t offer(std::string_view bytes);
  int descriptor() const { return socket_; }  ///< to poll
  void get(const std::string& target);
  /// No more will be sent.
  void finish();
  void leave();
  bool readable(milliseconds wait = milliseconds(0)) const;
  /// Reads on until the bytes end with the mark, or the server closes, and takes them.
  std::string until(std::string_view mark);
  /// All bytes until the server closes. Errors: std::runtime_error if it does not in time.
  std::string rest(milliseconds timeout = seconds(60));
  /// So many bytes at most; "" = the server has closed.
  std::string read(std::size_t most, milliseconds timeout = seconds(60));

 private:
  Witness witness_;
  int socket_ = -1;
};

int status_of(const std::string& answer);
std::string body_of(const std::string& answer);

}  // namespace tia::test
