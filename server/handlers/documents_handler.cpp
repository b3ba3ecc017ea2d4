// The documents that tell of the server itself: /openapi.json, /docs, /problems/TYPE.
#include <algorithm>

#include "core/input/json.h"
#include "server/contract/openapi.h"
#include "server/contract/problem_table.h"
#include "server/handlers/docs_page.h"
#include "server/handlers/handlers.h"
#include "server/handlers/route_table.h"
#include "server/http/error.h"
#include "server/requests/tagged.h"

namespace tia::server {

Response get_openapi(const Request& request, const std::string&, Service&) {
  static const std::string text = to_json(openapi_document(routes()));
  static const Tagged tagged(text);
  return tagged_response(request, tagged, "application/json");
}

Response get_docs(const Request& request, const std::string&, Service&) {
  static const std::string text = docs_page();
  static const Tagged tagged(text);
  return tagged_response(request, tagged, "text/html; charset=utf-8");
}

Response get_problem(const Request&, const std::string& type, Service&) {
  const auto rows = problem_rows();
  if (std::none_of(rows.begin(), rows.end(),
                   [&](const ProblemRow& row) { return row.type == type; }))
    throw HttpError("not-found", "there is no such type of problem");
  return {.status = 308,
          .content_type = "",
          .body = "",
          .headers = {{"Location", "/docs#" + problem_anchor(type)}}};
}

}  // namespace tia::server
