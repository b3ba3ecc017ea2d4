#include "server/contract/security.h"

namespace tia::server {

Value::Array security_array(const Route& route) {
  Value::Array rights;
  for (const Right right : route.rights) rights.emplace_back(name_of(right));
  Value::Array ways{Value::Object{{"key", rights}}};
  if (route.method == "GET")
    ways.push_back(Value::Object{{"exp", rights}, {"kid", rights}, {"sig", rights}});
  ways.push_back(Value::Object{});
  return ways;
}

Value security_schemes() {
  const auto in_query = [](const char* name, const char* about) {
    return Value::Object{
        {"type", "apiKey"}, {"in", "query"}, {"name", name}, {"description", about}};
  };
  const Value::Object key{{"type", "http"},
                          {"scheme", "bearer"},
                          {"bearerFormat", "ID.SECRET"},
                          {"description", "a key of TIA_KEYS_FILE, which `tia key ID` makes"}};
  return Value::Object{
      {"key", key},
      {"exp", in_query("exp", "of a URL that `tia sign` makes: when it ends, seconds since 1970")},
      {"kid", in_query("kid", "which key of TIA_SIGN_FILE has signed it")},
      {"sig", in_query("sig",
                       "base64url(HMAC-SHA256) of path and query before it; these three "
                       "are the last parameters, in this order")}};
}

}  // namespace tia::server
