#include "server/problem.h"

#include <algorithm>
#include <array>
#include <new>

#include "core/input/json.h"
#include "core/render/pool.h"
#include "server/log.h"

namespace tia::server {
namespace {

struct Row {
  std::string_view type;
  int status;
  std::string_view title;
};
constexpr std::array rows{
    Row{"malformed", 400, "The request cannot be read"},
    Row{"unknown-name", 422, "A name is not known"},
    Row{"wrong-type", 422, "A value has the wrong type"},
    Row{"out-of-range", 422, "A value is out of range"},
    Row{"missing", 422, "Something is missing"},
    Row{"conflict", 422, "Two things exclude each other"},
    Row{"limit", 422, "The request asks for more than this server gives"},
    Row{"not-found", 404, "Nothing is here"},
    Row{"method", 405, "The method is not allowed here"},
    Row{"not-acceptable", 406, "The client accepts nothing that is here"},
    Row{"slow", 408, "The request came too slowly"},
    Row{"length-required", 411, "The body's length is not announced"},
    Row{"too-large", 413, "The request's body is too large"},
    Row{"uri-too-long", 414, "The URL is too long; POST /render takes the same as a JSON object"},
    Row{"media-type", 415, "The body is of a type that is not read here"},
    Row{"expectation", 417, "The expectation cannot be met"},
    Row{"busy", 429, "The server has too much to do"},
    Row{"header-too-large", 431, "The request's head is too large"},
    Row{"internal", 500, "The server made a mistake"},
    Row{"not-implemented", 501, "The server does not know this part of HTTP"},
    Row{"timeout", 503, "The answer took too long"},
    Row{"memory", 503, "The server is short of memory"},
    Row{"draining", 503, "The server is going down"},
    Row{"storage", 503, "What is kept cannot be reached"},
    Row{"version", 505, "The server does not speak this version of HTTP"},
    Row{"storage-full", 507, "There is no room to keep more"},
};

const Row& row_of(std::string_view type) {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.type == type; });
  return found == rows.end() ? row_of("internal") : *found;
}

std::string_view type_of(FaultKind kind) {
  switch (kind) {
    case FaultKind::malformed: return "malformed";
    case FaultKind::unknown_name: return "unknown-name";
    case FaultKind::wrong_type: return "wrong-type";
    case FaultKind::out_of_range: return "out-of-range";
    case FaultKind::missing: return "missing";
    case FaultKind::conflict: return "conflict";
    case FaultKind::limit: return "limit";
  }
  return "internal";
}

Value error_entry(const Fault& fault) {
  Value::Object entry{{"pointer", fault.pointer}, {"allowed", fault.allowed}};
  if (fault.got) entry.emplace_back("got", excerpt(*fault.got));
  if (!fault.nearest.empty()) entry.emplace_back("nearest", fault.nearest);
  if (fault.column) entry.emplace_back("column", static_cast<double>(*fault.column));
  return entry;
}

Response document(const Row& row, const std::string& detail, const Request& request,
                  Value::Array errors = {}) {
  Value::Object problem{{"type", "/problems/" + std::string(row.type)},
                        {"title", row.title},
                        {"status", row.status},
                        {"detail", detail},
                        {"instance", request.id}};
  if (!errors.empty()) problem.emplace_back("errors", std::move(errors));
  return {.status = row.status,
          .content_type = "application/problem+json",
          .body = to_json(problem),
          .headers = {{"Cache-Control", "no-store"}, {"X-Request-Id", request.id}},
          .problem = row.type};
}

// The first malformed fault speaks for the whole, else the first.
Response input_problem(const InputError& error, const Request& request) {
  const auto& faults = error.faults();
  const auto malformed = std::find_if(faults.begin(), faults.end(), [](const Fault& fault) {
    return fault.kind == FaultKind::malformed;
  });
  const Fault& first = malformed == faults.end() ? faults.front() : *malformed;
  Value::Array errors;
  for (const Fault& fault : faults) errors.push_back(error_entry(fault));
  Fault brief = first;
  if (brief.got) brief.got = excerpt(*brief.got);
  std::string detail = describe(brief);
  if (faults.size() > 1)
    detail = std::to_string(faults.size()) + " faults, listed in errors; one is " + detail;
  return document(row_of(type_of(first.kind)), detail, request, std::move(errors));
}

Response passing_problem(std::string_view type, const char* detail, const Request& request) {
  Response response = document(row_of(type), detail, request);
  response.headers.emplace_back("Retry-After", "1");
  return response;
}

Response memory_problem(const Request& request) {
  log_failure(request.id, "out of memory");
  return passing_problem("memory", "there is no memory for the answer now; ask again or for less",
                         request);
}

Response storage_problem(const StorageError& error, const Request& request) {
  log_failure(request.id, error.what());
  return passing_problem(
      "storage",
      "the file of kept scenes cannot be used; what is wrong with it is in the server's log",
      request);
}

}  // namespace

std::exception_ptr failure(std::string_view type, std::string detail, Headers headers) {
  return std::make_exception_ptr(HttpError(type, std::move(detail), std::move(headers)));
}

Response problem_response(const std::exception_ptr& failure, const Request& request) {
  try {
    std::rethrow_exception(failure);
  } catch (const InputError& error) {
    return input_problem(error, request);
  } catch (const HttpError& error) {
    Response response = document(row_of(error.type()), error.detail(), request);
    const auto& more = error.headers();
    response.headers.insert(response.headers.end(), more.begin(), more.end());
    return response;
  } catch (const Stopped&) {
    return document(row_of("draining"), "the render was stopped", request);
  } catch (const std::bad_alloc&) {
    return memory_problem(request);
  } catch (const StorageError& error) {
    return storage_problem(error, request);
  } catch (const std::exception& error) {
    log_failure(request.id, error.what());
  } catch (...) {
    log_failure(request.id, "unknown");
  }
  return document(row_of("internal"), "it is in the server's log under this id", request);
}

HttpError uri_too_long() {
  return {"uri-too-long", "a URL may have " + std::to_string(longest_target) +
                              " bytes; send the parameters as a JSON object with POST /render"};
}

}  // namespace tia::server
