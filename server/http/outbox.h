// What a connection has to send.
#pragma once

#include <algorithm>
#include <asio/buffer.hpp>
#include <asio/error.hpp>
#include <asio/ip/tcp.hpp>
#include <string>

#include "server/http/patience.h"

namespace tia::server {

class Outbox {
 public:
  void put(std::string bytes) {
    if (bytes_.empty()) bytes_ = std::move(bytes);
    else bytes_ += bytes;
  }
  bool empty() const { return bytes_.empty(); }
  /// Bytes that have gone out since the last call of begin().
  std::size_t sent() const { return sent_; }
  void begin() { sent_ = 0; }

  /// Sends what the socket takes now, but not so much that others wait for it. Returns: no error
  /// once all has been sent; would_block while there is more.
  asio::error_code send(asio::ip::tcp::socket& socket) {
    asio::error_code error;
    if (bytes_.empty()) return error;
    const std::size_t size = std::min(bytes_.size() - first_, patience::most_at_once);
    const std::size_t sent = socket.write_some(asio::buffer(bytes_.data() + first_, size), error);
    first_ += sent;
    sent_ += sent;
    if (error) return error;
    if (first_ < bytes_.size()) return asio::error::would_block;
    clear();
    return error;
  }
  /// Bytes of memory that it takes.
  std::size_t held() const { return bytes_.capacity(); }

 private:
  void clear() {
    if (bytes_.capacity() > patience::most_ahead) std::string().swap(bytes_);
    bytes_.clear();
    first_ = 0;
  }

  std::string bytes_;
  std::size_t first_ = 0;  // of the bytes that have not gone out
  std::size_t sent_ = 0;
};

}  // namespace tia::server
