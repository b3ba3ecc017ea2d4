// A stream of bytes to another machine, in the clear or by TLS, where whatever waits has a
// deadline.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace tia::server {

/// RedisSocket: one connection. One thread at a time.
/// Errors, of all that follows: std::runtime_error that says what failed, the deadline included;
/// then the connection is of no more use.
class RedisSocket {
 public:
  using Deadline = std::chrono::steady_clock::time_point;

  /// Connects. With TLS the other's certificate must be of that host's name and lead to one of
  /// `ca_file`, or of the system's where that is "".
  RedisSocket(const std::string& host, int port, bool is_tls, const std::string& ca_file,
              Deadline until);
  ~RedisSocket();
  RedisSocket(const RedisSocket&) = delete;
  RedisSocket& operator=(const RedisSocket&) = delete;

  void write(std::string_view bytes, Deadline until);
  /// At least one byte, at most so many as there are by then. Returns: none where none came in
  /// time.
  std::string_view read(Deadline until);
  /// Ends what another thread waits for here; it fails there.
  void interrupt();

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
};

}  // namespace tia::server
