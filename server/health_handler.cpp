// /healthz and /version.
#include "core/input/json.h"
#include "core/math/wide.h"
#include "core/version.h"
#include "server/handlers.h"

namespace tia::server {
namespace {

#if defined(__clang__)
constexpr std::string_view compiler = "clang " __clang_version__;
#else
constexpr std::string_view compiler = "gcc " __VERSION__;
#endif

}  // namespace

Response get_health(const Request&, const std::string&, Service&) {
  return {.content_type = "application/json",
          .body = R"({"status":"ok"})",
          .headers = {{"Cache-Control", "no-store"}}};
}

Response get_version(const Request&, const std::string&, Service&) {
  const Value::Object build{{"name", "tia"},
                            {"version", version()},
                            {"bytes", full_version()},
                            {"compiler", compiler},
                            {"lanes", lanes<Wide>}};
  return {.content_type = "application/json", .body = to_json(build)};
}

}  // namespace tia::server
