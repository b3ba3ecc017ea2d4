#include "server/contract/problem.h"

#include <algorithm>
#include <new>

#include "core/input/json.h"
#include "core/models/multipart.h"
#include "core/parallel/stopped.h"
#include "server/contract/problem_table.h"

namespace tia::server {
namespace {

std::string_view type_of(FaultKind kind) {
  switch (kind) {
    case FaultKind::malformed: return "malformed";
    case FaultKind::unknown_name: return "unknown-name";
    case FaultKind::wrong_type: return "wrong-type";
    case FaultKind::out_of_range: return "out-of-range";
    case FaultKind::missing: return "missing";
    case FaultKind::conflict: return "conflict";
    case FaultKind::limit: return "limit";
    case FaultKind::unreadable: return "unreadable";
  }
  return "internal";
}

Value error_entry(const Fault& fault) {
  Value::Object entry{{"pointer", fault.pointer}, {"allowed", fault.allowed}};
  if (fault.got) entry.emplace_back("got", *fault.got);
  if (!fault.nearest.empty()) entry.emplace_back("nearest", fault.nearest);
  if (fault.column) entry.emplace_back("column", static_cast<double>(*fault.column));
  if (fault.line) entry.emplace_back("line", static_cast<double>(*fault.line));
  return entry;
}

// A document's detail; all that it has beside detail and errors, of which the id is the longest.
constexpr std::size_t longest_detail = 2048, longest_rest = 512;

// As many of the faults as a document of so many bytes has room for.
Value::Array entries_of(const std::vector<Fault>& faults, std::size_t longest) {
  std::size_t room = longest - longest_detail - longest_rest;
  Value::Array entries;
  for (const Fault& fault : faults) {
    Value entry = error_entry(fault);
    const std::size_t bytes = to_json(entry).size() + 1;  // and a comma
    if (bytes > room) break;
    room -= bytes;
    entries.push_back(std::move(entry));
  }
  return entries;
}

Response document(const ProblemRow& row, const std::string& detail, const Request& request,
                  Value::Array errors = {}) {
  Value::Object problem{{"type", problem_uri(row)},
                        {"title", row.title},
                        {"status", row.status},
                        {"detail", excerpt_of(detail, longest_detail)},
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
  const bool is_form = boundary_of(request.header("Content-Type")).has_value();
  Value::Array errors = entries_of(faults, is_form ? longest_form_problem : longest_problem);
  std::string detail = describe(first);
  if (faults.size() > 1)
    detail =
        std::to_string(faults.size()) + " faults, " +
        (errors.size() < faults.size() ? "the first " + std::to_string(errors.size()) + " " : "") +
        "listed in errors; one is " + detail;
  return document(problem_row(type_of(first.kind)), detail, request, std::move(errors));
}

Response passing_problem(std::string_view type, const char* detail, const Request& request) {
  Response response = document(problem_row(type), detail, request);
  response.headers.emplace_back("Retry-After", "1");
  return response;
}

Response for_the_log(const char* what, Response response) {
  response.failure = what;
  return response;
}

Response memory_problem(const Request& request) {
  return for_the_log(
      "out of memory",
      passing_problem("memory", "there is no memory for the answer now; ask again or for less",
                      request));
}

Response storage_problem(const StorageError& error, const Request& request) {
  return for_the_log(
      error.what(),
      passing_problem("storage",
                      "what is kept cannot be used; what is wrong with it is in the server's log",
                      request));
}

Response away_problem(const StorageAway& error, const Request& request) {
  return for_the_log(
      error.what(),
      passing_problem("unavailable", "what keeps jobs cannot be reached now; all else works",
                      request));
}

Response internal_problem(const char* what, const Request& request) {
  return for_the_log(
      what, document(problem_row("internal"), "it is in the server's log under this id", request));
}

}  // namespace

Response problem_response(const std::exception_ptr& failure, const Request& request) {
  try {
    std::rethrow_exception(failure);
  } catch (const InputError& error) {
    return input_problem(error, request);
  } catch (const HttpError& error) {
    Response response = document(problem_row(error.type()), error.detail(), request);
    const auto& more = error.headers();
    response.headers.insert(response.headers.end(), more.begin(), more.end());
    return response;
  } catch (const Stopped&) {
    return passing_problem("draining", "the render was stopped", request);
  } catch (const std::bad_alloc&) {
    return memory_problem(request);
  } catch (const StorageAway& error) {
    return away_problem(error, request);
  } catch (const StorageError& error) {
    return storage_problem(error, request);
  } catch (const std::exception& error) {
    return internal_problem(error.what(), request);
  } catch (...) {
    return internal_problem("unknown", request);
  }
}

}  // namespace tia::server
