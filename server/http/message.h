// A request and its answer as plain data: all that the rest of the server sees of HTTP.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/input/value.h"
#include "server/http/trace_context.h"

namespace tia::server {

struct Caller;  // whom a request is from (access/caller.h)

/// Header fields in order. Names compare without case.
using Headers = std::vector<std::pair<std::string, std::string>>;

using Clock = std::chrono::steady_clock;

/// The text without the white space around it (RFC 9110, 5.6.3).
std::string_view trimmed(std::string_view text);

/// Whether two names of header fields, or two of HTTP's keywords, are the same: without case.
bool same_word(std::string_view a, std::string_view b);

/// LongBody: where a body goes, as it comes, that is too long to be held in memory.
class LongBody {
 public:
  LongBody() = default;
  LongBody(const LongBody&) = delete;
  LongBody& operator=(const LongBody&) = delete;
  virtual ~LongBody() = default;

  /// Takes the next bytes; by one thread at a time, which may have to wait. Errors: HttpError;
  /// whatever it throws refuses the request.
  virtual void append(std::string_view bytes) = 0;
  virtual std::size_t size() const = 0;  ///< of what has come
};

struct Request {
  std::string method;
  std::string target;  ///< path and query as they came, still percent-encoded
  Headers headers;
  std::string body;  ///< unless it is in `long_body`
  std::string id;    ///< X-Request-Id: the client's where it is fit for a log line, else our own
  std::string peer = {};  ///< the client's address, as its proxies tell it where they are trusted
  bool is_http_1_0 = false;
  std::optional<TraceContext> trace = {};  ///< where who asks has sent a traceparent
  std::stop_token stop = {};               ///< requested once nobody waits for the answer any more
  Clock::time_point arrived = Clock::now();  ///< when its last byte had come
  std::shared_ptr<LongBody> long_body = {};  ///< has the body in the place of `body`; or null
  std::string key = {};  ///< the id of the key that it came with, which holds; "" = none
  std::shared_ptr<const Caller> caller = {};  ///< null where it does not say whom it is from

  std::string_view path() const { return std::string_view(target).substr(0, target.find('?')); }
  std::string_view query() const {
    const auto mark = target.find('?');
    return mark == target.npos ? std::string_view() : std::string_view(target).substr(mark + 1);
  }
  /// The first field of that name, or "".
  std::string_view header(std::string_view name) const;
  bool is_head() const { return method == "HEAD"; }
  std::size_t body_bytes() const { return long_body ? long_body->size() : body.size(); }
};

/// SendPart: sends parts of an answer, none of them empty.
struct SendPart {
  /// The next one; waits while the client is slow. Errors: Stopped once the client has left or the
  /// request's time is up.
  std::function<void(std::string_view)> next;
  /// One that takes the place of the last such one, unless that is on its way; never waits. Any
  /// thread may call, while no other sends. Nobody hears it where the client has left.
  std::function<void(std::string_view)> latest = [](std::string_view) {};
  /// Waits until all of them are on their way: a client that reads slowly so has one at most to
  /// come. Errors: as next.
  std::function<void()> await_taken = [] {};

  void operator()(std::string_view part) const { next(part); }
};

/// Feed: a body that comes by and by, and for which no worker waits.
class Feed {
 public:
  /// Piece: what has come, and whether it is the end.
  struct Piece {
    std::string bytes;
    bool is_last = false;
  };
  Feed() = default;
  Feed(const Feed&) = delete;
  Feed& operator=(const Feed&) = delete;
  virtual ~Feed() = default;

  /// What has come since the last call, some KiB at most; never waits.
  virtual Piece take() = 0;
  /// Has `more` called, by any thread, whenever something has come: at once, if it has already.
  /// Null: nobody listens any more.
  virtual void listen(std::function<void()> more) = 0;
};

struct Response {
  int status = 200;
  std::string content_type;  ///< "" = no body
  std::string body;
  Headers headers = {};
  /// Bytes that others have too, in the body's place: they are sent, not copied.
  std::shared_ptr<const std::string> shared = nullptr;
  bool unsized = false;  ///< HEAD of something that would have to be made to be measured
  /// Makes the body in parts while they are sent, in the body's place. The head goes with the first
  /// one: until then what fails is answered as ever.
  std::function<void(const SendPart&)> parts = nullptr;
  /// What the parts may take from the request's arrival on; 0: no more than any answer. For so long
  /// only who takes them at the slowest rate is waited for.
  std::chrono::milliseconds parts_deadline{};
  /// Makes the body by and by, in the body's place: for as long as the client stays and takes it.
  std::shared_ptr<Feed> feed = nullptr;
  /// The part that tells of a problem, by its document, where the others have to end with it; null:
  /// the body is cut.
  std::string (*problem_part)(const std::string& document) = nullptr;
  std::string_view problem = {};  ///< the type of the problem that it tells, for the log; "" = none
  Value::Object log = {};         ///< what the log says of it besides
  std::string failure = {};       ///< what went wrong and is for the log alone; "" = nothing did
};

/// Strict percent-decoding, '+' as it stands. Errors: InputError of kind malformed at `pointer`.
std::string percent_decode(std::string_view text, std::string_view pointer = "");

}  // namespace tia::server
