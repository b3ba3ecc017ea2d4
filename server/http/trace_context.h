// Trace context: which of many servers' answers belong together, as who asks tells it.
// Source: W3C Trace Context (2021), sections 3.2 and 4.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tia::server {

/// TraceContext: a request's place among those of its trace. Ids are lower-case hexadecimal digits.
struct TraceContext {
  std::string trace_id;   ///< of the whole, 32 digits
  std::string parent_id;  ///< of who asks, 16 digits
  std::string span_id;    ///< of this request, 16 digits, new
  std::string flags;      ///< 2 digits: whether who asks keeps the trace, and has drawn its id

  /// What is handed on: version 00 of the field, with our own id as the next one's parent.
  std::string traceparent() const;
};

/// What a traceparent field says. none: it is not valid, and then the request has no trace but its
/// X-Request-Id. Of later versions the part is read that version 00 has, as section 3.2.3 asks.
std::optional<TraceContext> trace_context(std::string_view traceparent);

/// An id's digits: what nobody need keep secret.
std::string random_digits(std::size_t count);

}  // namespace tia::server
