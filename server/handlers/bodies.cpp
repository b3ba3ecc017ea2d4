#include "server/handlers/bodies.h"

#include "server/http/head.h"
#include "server/http/peers.h"

namespace tia::server {

Requester requester_of(const Request& request) {
  return {share_of(request.peer), request.stop, request.key};
}

// What calls itself a picture may be longer than a text, and be none.
LongWork::Need body_need(const Request& request, const Service& service) {
  const std::size_t bytes = request.body.size();
  check_length(bytes, {service.config.max_body_bytes});
  return {bytes, memory_for_text(bytes, service.config.json_limits().values), "what the body says"};
}

bool holds_json(std::string_view query) {
  for (const std::string_view sign : {"{", "[", "%7B", "%7b", "%5B", "%5b"})
    if (query.find(sign) != query.npos) return true;
  return false;
}
LongWork::Need query_need(const Request& request, const Service& service) {
  const std::size_t bytes = request.query().size();
  return {bytes, memory_for_text(bytes, service.config.json_limits().values),
          "what the query says"};
}

}  // namespace tia::server
