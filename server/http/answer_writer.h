// Responses -> bytes. The one place that uses cpp-httplib's server: of its parts the one that
// frames answers. What it would read of a request has been read more strictly already.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "server/http/message.h"

namespace tia::server {

/// Takes bytes of an answer, in order: a part that is not the latest one any more need not be sent.
/// `taken` comes without bytes, and waits until those before it are on their way.
/// Returns: whether it wants more.
enum class Part { next, latest, taken };
using TakeBytes = std::function<bool(std::string_view, Part)>;

/// Writes the answer to a request as HTTP/1.1: status line, fields, Content-Length and body; a body
/// made in parts goes chunked, as its parts are made, the whole head first. Takes the body out of
/// the response.
/// Errors: what making the parts throws.
void write_answer(Response& response, bool is_head, bool keep_alive, const TakeBytes& take);

/// A part as a chunk of a body, and what ends that. Source: RFC 9112, 7.1.
std::string chunk_of(std::string_view part);
constexpr std::string_view last_chunk = "0\r\n\r\n";

/// The same, whole, but for a body that others have too. Domain: a response without parts.
std::string answer_bytes(Response& response, bool is_head, bool keep_alive);

}  // namespace tia::server
