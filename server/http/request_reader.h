// Bytes -> requests, without a socket: what a connection, a test and a fuzzer feed.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "server/http/chunks.h"
#include "server/http/head.h"

namespace tia::server {

/// BodyLimits: how long the bodies of requests may be: pictures that are sent back, and all else;
/// and what some have of their own.
struct BodyLimits {
  BodyLimits(std::int64_t most_bytes) : BodyLimits(most_bytes, most_bytes) {}
  BodyLimits(std::int64_t most_bytes, std::int64_t most_png_bytes)
      : any{most_bytes}, png{most_png_bytes, "TIA_MAX_PNG_BYTES"} {}
  BodyLimit any, png;
  std::function<std::optional<BodyLimit>(const Request&)> own = [](const Request&) {
    return std::nullopt;
  };
};

/// Bodies that are longer are put away as they come, where there is a LongBody for them.
inline constexpr std::size_t longest_held_body = 1 << 20;

/// Where the body of a request may go whose head this is, or null.
using MakeLongBody = std::function<std::shared_ptr<LongBody>(const Request&)>;

/// RequestReader: takes one request after the other out of a connection's bytes. Once it has
/// thrown, where the next request begins is unknown: the connection can only be closed.
class RequestReader {
 public:
  enum class State { idle, head, body, whole };

  explicit RequestReader(
      const BodyLimits& limits, MakeLongBody long_body = [](const Request&) { return nullptr; })
      : limits_(limits), make_long_body_(std::move(long_body)), chunks_(limits.any) {}

  void feed(std::string_view bytes) { bytes_.append(bytes); }
  /// Reads on as far as the bytes reach. `idle` is before the first byte of a request.
  /// Errors: HttpError.
  State read();
  State state() const { return state_; }
  /// Whether the client waits to be told that it may send the body; true once a request.
  bool wants_continue();
  /// Whether there is a portion of a long body that ought to be put away before anything is read
  /// on: enough for one go, or the last one.
  bool has_portion() const;
  /// It, which is for the request's long_body; in order.
  std::string take_portion();
  /// The whole request; the next one begins after it.
  /// Domain: state() == whole, and no portion is left.
  Request take();
  /// What is known of the request; all of it but the body where read() threw after its head.
  const Request& request() const { return request_; }
  /// Whether the connection may be used again after this request.
  bool keep_alive() const { return head_.keep_alive; }
  /// How many bytes of the body have come so far.
  std::size_t body_bytes() const { return taken_ + request_.body.size(); }
  /// Bytes that are held: of the request, and not yet read.
  std::size_t held() const { return bytes_.capacity() + request_.body.capacity(); }
  std::size_t unread() const { return bytes_.size(); }

 private:
  void skip_empty_line();
  bool read_head();
  BodyLimit limit_of(const Request& request) const;
  bool read_body();
  bool read_sized_body();
  bool read_chunks();

  BodyLimits limits_;
  MakeLongBody make_long_body_;
  State state_ = State::idle;
  std::string bytes_;        // fed and not yet read
  std::size_t scanned_ = 0;  // how many of them hold no end of a head
  Head head_;
  ChunkDecoder chunks_;
  Request request_;
  std::size_t taken_ = 0;         // of the body, by take_portion()
  bool stays_in_memory_ = false;  // the body, however long
  bool skipped_ = false;
};

/// An id fit for a log line and an answer's head: the client's, or 16 random hexadecimal digits.
std::string request_id(std::string_view asked);

}  // namespace tia::server
