#include "server/contract/problem_table.h"

#include <algorithm>
#include <array>

#include "core/input/object_schema.h"

namespace tia::server {
namespace {

// Of no memory but the program's own: it is needed where there is none.
constexpr std::array table{
    ProblemRow{"malformed", 400, "The request cannot be read", Met::by_any,
               "It is no HTTP that can be read in only one way, no JSON, or not well encoded."},
    ProblemRow{"unknown-name", 422, "A name is not known", Met::by_input,
               "A parameter, a member or a word that there is not; errors name the nearest that "
               "there is."},
    ProblemRow{"wrong-type", 422, "A value has the wrong type", Met::by_input,
               "Such as a text for a number."},
    ProblemRow{"out-of-range", 422, "A value is out of range", Met::by_input,
               "Errors say what came and what is allowed."},
    ProblemRow{"missing", 422, "Something is missing", Met::by_input,
               "Something without a default."},
    ProblemRow{"conflict", 422, "Two things exclude each other", Met::by_input,
               "Such as key and light, which both say where the light is."},
    ProblemRow{
        "limit", 422, "The request asks for more than this server gives", Met::by_input,
        "More pixels, rays, tests or JSON values than an option allows; the detail names it."},
    ProblemRow{
        "unreadable", 422, "A file cannot be read as what it is", Met::by_input,
        "A model's, which ends too early, or has a word for a number; errors name its line."},
    ProblemRow{"unauthorized", 401, "A key is needed that holds", Met::by_right,
               "None came with the request, or one that is unknown, wrong or has ended; or the "
               "signature of a URL does not fit, or has ended.",
               "WWW-Authenticate"},
    ProblemRow{"forbidden", 403, "This is not for who asks", Met::by_right,
               "A key without the right to it, a page of another origin that writes, or a wrong "
               "Tia-Delete-Key."},
    ProblemRow{"not-found", 404, "Nothing is here", Met::by_name,
               "No such path, or no such name in it."},
    ProblemRow{"method", 405, "The method is not allowed here", Met::by_method,
               "The path is for other methods.", "Allow"},
    ProblemRow{"not-acceptable", 406, "The client accepts nothing that is here", Met::by_accept,
               "Accept excludes every media type of the answer."},
    ProblemRow{"not-ready", 409, "The result is not there yet", Met::by_job,
               "A job has not drawn it yet. Retry-After says when to ask again.", "Retry-After"},
    ProblemRow{"gone", 410, "The result is not there any more", Met::by_job,
               "The job was cancelled, or its results were kept for TIA_JOB_KEEP_S, or made room "
               "for others'."},
    ProblemRow{"slow", 408, "The request came too slowly", Met::by_any,
               "A head may take 5 s, a body must come at 64 KiB/s."},
    ProblemRow{"length-required", 411, "The body's length is not announced", Met::by_body,
               "A body needs Content-Length, or to be chunked."},
    ProblemRow{
        "too-large", 413, "The request, or what it asks for, is too large", Met::by_size,
        "More bytes than TIA_MAX_BODY_BYTES, or, of type image/png, TIA_MAX_PNG_BYTES, or, of a "
        "model, TIA_MAX_MODEL_BYTES; or what it asks for may take more memory than "
        "TIA_MEMORY_BYTES gives one request."},
    ProblemRow{"uri-too-long", 414,
               "The URL is too long; POST /render takes the same as a JSON object", Met::by_any,
               "More than 4096 bytes."},
    ProblemRow{"media-type", 415, "The body is of a type that is not read here", Met::by_body,
               "Neither JSON nor, where one is taken, a PNG or a model; or compressed.",
               "Accept-Encoding"},
    ProblemRow{"expectation", 417, "The expectation cannot be met", Met::by_any,
               "Expect with something else than 100-continue."},
    ProblemRow{"misdirected", 421, "The server is not called that", Met::by_any,
               "Host is none of TIA_HOSTS."},
    ProblemRow{"busy", 429, "The server has too much to do", Met::by_any,
               "Connections, queue or memory are full. Retry-After says when to ask again.",
               "Retry-After"},
    ProblemRow{"quota", 429, "The key has used up what it may", Met::by_right,
               "Its requests a second, its rays a day, its unfinished jobs, or what its jobs keep. "
               "Retry-After says when there are more, or when to ask again.",
               "Retry-After"},
    ProblemRow{"header-too-large", 431, "The request's head is too large", Met::by_any,
               "More than 16 KiB or 100 fields."},
    ProblemRow{"internal", 500, "The server made a mistake", Met::by_any,
               "It has logged what happened under the request's id."},
    ProblemRow{"not-implemented", 501, "The server does not know this part of HTTP", Met::by_any,
               "Such as a transfer coding other than chunked."},
    ProblemRow{"unavailable", 503, "What keeps jobs is away", Met::by_any,
               "Ask again: all else works meanwhile.", "Retry-After"},
    ProblemRow{"timeout", 503, "The answer took too long", Met::by_any,
               "More than TIA_DEADLINE_MS, the wait in the queue included.", "Retry-After"},
    ProblemRow{"budget", 503, "The budget is too short", Met::by_input,
               "budget_ms was over before each pixel had its first samples.", "Retry-After"},
    ProblemRow{"memory", 503, "The server is short of memory", Met::by_any,
               "Ask again, or for less.", "Retry-After"},
    ProblemRow{"draining", 503, "The server is going down", Met::by_any,
               "Ask again: another one may answer.", "Retry-After"},
    ProblemRow{
        "storage", 503, "What is kept cannot be reached", Met::by_any,
        "The file of kept scenes or the folder of kept models cannot be read or written; the log "
        "says why.",
        "Retry-After"},
    ProblemRow{"version", 505, "The server does not speak this version of HTTP", Met::by_any,
               "It speaks HTTP/1.1 and HTTP/1.0."},
    ProblemRow{"storage-full", 507, "There is no room to keep more", Met::by_body,
               "The file of kept scenes, or the folder of kept models, is as large as "
               "TIA_MAX_DATA_BYTES, or the disk is full."},
};

Value error_schema() {
  return object_schema(
      {{"pointer", plain_schema<std::string>(),
        "where: a JSON Pointer (RFC 6901) into the request as a JSON object; of a long one, or of "
        "a "
        "long name in it, the start and how much is left out, \"abc… (3912 bytes more)\""},
       {"allowed", plain_schema<std::string>(), "what may stand there, in words"},
       {"got", Value::Object{}, "what stood there, cut short; none where it is missing", false},
       {"nearest", plain_schema<std::string>(), "the known name nearest to it", false},
       {"column", count_schema(1), "where in a formula, in bytes", false},
       {"line", count_schema(1), "where in a file of lines", false}});
}

// Type, title and status belong together.
Value::Array problem_kinds() {
  Value::Array kinds;
  for (const ProblemRow& row : problem_rows()) {
    const auto only = [](const Value& value) { return Value::Object{{"const", value}}; };
    kinds.push_back(Value::Object{{"properties", Value::Object{{"type", only(problem_uri(row))},
                                                               {"title", only(row.title)},
                                                               {"status", only(row.status)}}}});
  }
  return kinds;
}

}  // namespace

std::span<const ProblemRow> problem_rows() { return table; }

const ProblemRow& problem_row(std::string_view type) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const ProblemRow& row) { return row.type == type; });
  return found == table.end() ? problem_row("internal") : *found;
}

std::string problem_uri(const ProblemRow& row) { return "/problems/" + std::string(row.type); }

Value problem_schema(Definitions& named) {
  return schema_called("problem", named, [] {
    Value::Object schema = std::move(
        *object_schema(
             {{"type", plain_schema<std::string>(), "what kind of problem it is"},
              {"title", plain_schema<std::string>(), "the same in words"},
              {"status", plain_schema<int>({.min = 400, .max = 599}), "the answer's status"},
              {"detail", plain_schema<std::string>(), "what went wrong this time"},
              {"instance", plain_schema<std::string>(), "the request's X-Request-Id"},
              {"errors", list_schema(error_schema()),
               "all faults, the first 20, or as many as 16 KiB, of a form 8 KiB, have room for",
               false}})
             .as<Value::Object>());
    schema.emplace_back("oneOf", problem_kinds());
    return Value(std::move(schema));
  });
}

}  // namespace tia::server
