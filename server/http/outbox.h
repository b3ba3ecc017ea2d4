// What a connection has to send.
#pragma once

#include <algorithm>
#include <array>
#include <asio/buffer.hpp>
#include <asio/error.hpp>
#include <asio/ip/tcp.hpp>
#include <memory>
#include <string>
#include <string_view>

#include "server/http/timeouts.h"

namespace tia::server {

class Outbox {
 public:
  /// `shared` follows the bytes, and stays whose it is. Domain: none is put before all has gone.
  void put(std::string bytes, std::shared_ptr<const std::string> shared = nullptr) {
    if (bytes_.empty()) bytes_ = std::move(bytes);
    else bytes_ += bytes;
    if (shared) shared_ = std::move(shared);
  }
  bool empty() const { return bytes_.empty() && !shared_; }
  /// Bytes that have gone out since the last call of begin().
  std::size_t sent() const { return sent_; }
  void begin() { sent_ = 0; }

  /// Sends what the socket takes now, but not so much that others wait for it. Returns: no error
  /// once all has been sent; would_block while there is more.
  asio::error_code send(asio::ip::tcp::socket& socket) {
    asio::error_code error;
    if (empty()) return error;
    // Both pieces at once: the head alone would be a packet of its own.
    const std::string_view tail = shared_ ? std::string_view(*shared_) : std::string_view();
    const std::size_t in_tail = first_ - std::min(first_, bytes_.size());
    const asio::const_buffer head = asio::buffer(bytes_) + first_;
    const std::array pieces{asio::buffer(head, timeouts::most_at_once),
                            asio::buffer(asio::buffer(tail) + in_tail, timeouts::most_at_once)};
    const std::size_t sent = socket.write_some(pieces, error);
    first_ += sent;
    sent_ += sent;
    if (error) return error;
    if (first_ < bytes_.size() + tail.size()) return asio::error::would_block;
    clear();
    return error;
  }
  /// Bytes of memory that it takes: of what others have too its part.
  std::size_t held() const {
    const auto owners = static_cast<std::size_t>(std::max(shared_.use_count(), 1L));
    return bytes_.capacity() + (shared_ ? shared_->size() / owners : 0);
  }

 private:
  void clear() {
    if (bytes_.capacity() > timeouts::most_ahead) std::string().swap(bytes_);
    bytes_.clear();
    shared_.reset();
    first_ = 0;
  }

  std::string bytes_;
  std::shared_ptr<const std::string> shared_;  // null: none follows
  std::size_t first_ = 0;  // of the bytes that have not gone out, the shared ones counted on
  std::size_t sent_ = 0;
};

}  // namespace tia::server
