#include "server/http/request_reader.h"

#include <algorithm>
#include <utility>

#include "server/http/error.h"
#include "server/http/timeouts.h"
#include "server/http/trace_context.h"

namespace tia::server {
namespace {

// Makes room for so many bytes of a body that will have `whole`: a string that grows by itself
// could take twice as many. For all of them once a fourth has come, so that little is copied.
void reserve(std::string& body, std::size_t size, std::size_t whole) {
  if (size <= body.capacity()) return;
  std::string larger;
  larger.reserve(whole / 4 <= size ? whole : std::max(size, 2 * body.capacity()));
  larger.append(body);
  body.swap(larger);
}

}  // namespace

RequestReader::State RequestReader::read() {
  if (state_ == State::idle) {
    skip_empty_line();
    if (!bytes_.empty() && (skipped_ || bytes_ != "\r")) state_ = State::head;
  }
  if (state_ == State::head && read_head()) state_ = State::body;
  if (state_ == State::body && read_body()) state_ = State::whole;
  return state_;
}

bool RequestReader::wants_continue() {
  const bool wants = state_ == State::body && bytes_.empty() && body_bytes() == 0;
  return wants && std::exchange(head_.expects_continue, false);
}

bool RequestReader::has_portion() const {
  if (!request_.long_body || request_.body.empty()) return false;
  return state_ == State::whole || request_.body.size() >= timeouts::most_at_once;
}
std::string RequestReader::take_portion() {
  taken_ += request_.body.size();
  return std::exchange(request_.body, {});
}

Request RequestReader::take() {
  request_.arrived = Clock::now();
  state_ = State::idle;
  skipped_ = stays_in_memory_ = false;
  taken_ = 0;
  if (bytes_.empty()) std::string().swap(bytes_);  // an idle connection holds nothing
  return std::exchange(request_, Request{});
}

// One empty line before a request is let pass: old clients end a body with it (RFC 9112, 2.2).
void RequestReader::skip_empty_line() {
  if (skipped_ || bytes_.substr(0, 2) != "\r\n") return;
  bytes_.erase(0, 2);
  skipped_ = true;
}

bool RequestReader::read_head() {
  const std::size_t from = scanned_ < 3 ? 0 : scanned_ - 3;
  const std::size_t end = bytes_.find("\r\n\r\n", from);
  const std::string_view known =
      std::string_view(bytes_).substr(0, end == bytes_.npos ? end : end + 4);
  constexpr std::size_t longest_line = longest_target + 64;
  const bool long_line =
      known.size() > longest_line && known.substr(0, longest_line).find("\r\n") == known.npos;
  // No further than the limit: what is wrong first counts, however many bytes come at once.
  check_lines(known.substr(0, (long_line ? longest_line : Head::most_bytes) + 1), from);
  if (long_line) throw uri_too_long();
  if (known.size() > Head::most_bytes)
    throw HttpError("header-too-large",
                    "a head may have " + std::to_string(Head::most_bytes) + " bytes");
  scanned_ = bytes_.size();
  if (end == bytes_.npos) return false;

  head_ = server::read_head(std::string_view(bytes_).substr(0, end + 4));
  bytes_.erase(0, end + 4);
  scanned_ = 0;
  request_.method = head_.method;
  request_.target = head_.target;
  request_.headers = std::move(head_.headers);
  request_.is_http_1_0 = head_.is_http_1_0;
  request_.id = request_id(request_.header("X-Request-Id"));
  request_.trace = trace_context(request_.header("traceparent"));
  const BodyLimit limit = limit_of(request_);
  chunks_ = ChunkDecoder(limit);
  check_length(static_cast<std::uint64_t>(head_.length), limit);
  return true;
}

BodyLimit RequestReader::limit_of(const Request& request) const {
  if (const auto own = limits_.own(request)) return *own;
  const bool is_png = same_word(request.header("Content-Type"), "image/png");
  return is_png ? limits_.png : limits_.any;
}

bool RequestReader::read_body() {
  const bool sized = head_.body != Head::Body::chunked;
  const bool ended = sized ? read_sized_body() : read_chunks();
  const auto known = sized ? static_cast<std::size_t>(head_.length) : body_bytes();
  if (known > longest_held_body && !request_.long_body && !stays_in_memory_) {
    request_.long_body = make_long_body_(request_);
    stays_in_memory_ = !request_.long_body;
  }
  return ended;
}

bool RequestReader::read_chunks() {
  std::string_view rest = bytes_;
  const bool ended = chunks_.decode(rest, request_.body);
  bytes_.erase(0, bytes_.size() - rest.size());
  return ended;
}

bool RequestReader::read_sized_body() {
  std::string& body = request_.body;
  const auto length = static_cast<std::size_t>(head_.length);
  const std::size_t size = std::min(length - body_bytes(), bytes_.size());
  reserve(body, body.size() + size, length);
  body.append(bytes_, 0, size);
  bytes_.erase(0, size);
  return body_bytes() == length;
}

std::string request_id(std::string_view asked) {
  const auto fit = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
           c == '_' || c == '.';
  };
  if (!asked.empty() && asked.size() <= 64 && std::all_of(asked.begin(), asked.end(), fit))
    return std::string(asked);
  return random_digits(16);
}

}  // namespace tia::server
