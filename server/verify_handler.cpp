// /verify: a PNG in, whether its bytes are what this version draws from its recipe out.
#include "core/input/json.h"
#include "core/input/written.h"
#include "server/digest.h"
#include "server/handlers.h"
#include "server/parameters.h"
#include "server/problem.h"
#include "server/recipe.h"

namespace tia::server {

enum class Verdict { same, different, other_version };

}  // namespace tia::server

template <>
struct tia::Names<tia::server::Verdict> {
  static constexpr std::array<std::string_view, 3> names{"same", "different", "other-version"};
};

namespace tia::server {
namespace {

/// Sent: a picture that has come back.
struct Sent {
  Recipe recipe;
  std::string sha256;
};

Sent sent_in(const Request& request, Service& service) {
  const auto ticket = reading_ticket(request, service);
  refuse_query(request);
  if (!is_png(request.body))
    throw HttpError("media-type", "send a PNG file, such as this server has sent");
  return {recipe_in(request.body, service.config, request.stop), sha256_hex(request.body)};
}

// Where the recipe comes from another version, what it draws is not known here.
Value::Object verdict_on(const Recipe& recipe, const Request& request, Service& service) {
  if (recipe.version != full_version()) return {{"verdict", name_of(Verdict::other_version)}};
  const auto asked = read_described<PictureRequest>(recipe.request, {}, request.stop);
  const Asker asker = asker_of(request);
  Plan plan = plan_of(asked, service.studio, asker);
  const auto found = picture_of(plan, etag_of(plan.recipe), asker, service);
  const std::string& expected = found.picture->bytes;
  return {{"verdict", name_of(expected == request.body ? Verdict::same : Verdict::different)},
          {"expected_sha256", sha256_hex(expected)}};
}

}  // namespace

Response post_verify(const Request& request, const std::string&, Service& service) {
  const auto [recipe, sha256] = sent_in(request, service);
  Value::Object told = verdict_on(recipe, request, service);
  told.emplace_back("sha256", sha256);
  told.emplace_back("version", full_version());
  told.emplace_back("drawn_by", recipe.version);
  told.emplace_back("request", recipe.request);
  return {.content_type = "application/json",
          .body = to_json(told),
          .headers = {{"Cache-Control", "no-store"}}};
}

Value verdict_schema(Definitions& named) {
  return schema_called("verdict", named, [] {
    const Value text = plain_schema<std::string>();
    return object_schema(
        {{"verdict", plain_schema<Verdict>(),
          "whether the bytes are what this version draws; what another draws is not known"},
         {"sha256", text, "of the bytes that came"},
         {"expected_sha256", text, "of what this version draws", false},
         {"version", text, "this version"},
         {"drawn_by", text, "the version that the picture says has drawn it"},
         {"request", Value::Object{{"type", "object"}}, "what POST /render takes"}});
  });
}

}  // namespace tia::server
