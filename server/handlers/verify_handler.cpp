// /verify: a PNG in, whether its bytes are what this version draws from its recipe out.
#include <optional>

#include "core/input/json.h"
#include "core/input/object_schema.h"
#include "core/version.h"
#include "server/contract/answers.h"
#include "server/contract/parameters.h"
#include "server/handlers/bodies.h"
#include "server/handlers/handlers.h"
#include "server/http/error.h"
#include "server/requests/draw.h"
#include "server/requests/recipe.h"
#include "server/stores/digest.h"

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
  std::optional<PictureRequest> asked;  // none: of another version what it draws is not known here
  std::string sha256;
};

Sent sent_in(const Request& request, Service& service) {
  refuse_query(request);
  if (!is_png(request.body))
    throw HttpError("media-type", "send a PNG file, such as this server has sent");
  return read_recipe_of_body(request, service, [&](Recipe recipe) {
    Sent sent{std::move(recipe), {}, sha256_hex(request.body)};
    if (sent.recipe.version == full_version())
      sent.asked = read_described<PictureRequest>(sent.recipe.request, {}, request.stop);
    return sent;
  });
}

// What this version draws; null where that is not known.
std::shared_ptr<const Picture> expected_of(const Sent& sent, const Request& request,
                                           Service& service) {
  if (!sent.asked) return nullptr;
  const Requester requester = requester_of(request);
  Plan plan = plan_of(*sent.asked, service.rendering, requester);
  return picture_of(plan, etag_of(plan.recipe), requester, service).picture;
}

std::string verdict_on(const Sent& sent, std::string_view body, const Picture* expected) {
  const bool same = expected != nullptr && expected->bytes == body;
  const Verdict verdict = same                  ? Verdict::same
                          : expected != nullptr ? Verdict::different
                                                : Verdict::other_version;
  Value::Object told{{"verdict", name_of(verdict)}};
  if (expected != nullptr)
    told.emplace_back("expected_sha256", same ? sent.sha256 : sha256_hex(expected->bytes));
  told.emplace_back("sha256", sent.sha256);
  told.emplace_back("version", full_version());
  told.emplace_back("drawn_by", sent.recipe.version);
  told.emplace_back("request", sent.recipe.request);
  return to_json(told);
}

// The verdict goes through all bytes of a picture: by turns.
Response post_verify(const Request& request, const std::string&, Service& service) {
  const Sent sent = sent_in(request, service);
  const auto expected = expected_of(sent, request, service);
  const auto text = [&] { return verdict_on(sent, request.body, expected.get()); };
  const std::int64_t memory = service.config.max_body_bytes;
  return {.content_type = "application/json",
          .body = service.rendering.long_work({request.body.size(), memory, "the verdict"},
                                              requester_of(request), text),
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

Answer verdict() {
  return ok("the verdict, and what the picture was drawn from", media::json, verdict_schema,
            {"Cache-Control"});
}

std::vector<Content> png_body() { return {{media::png}}; }

}  // namespace

std::vector<Route> verify_routes() {
  return {{.method = "POST",
           .path = "/verify",
           .name = "post_verify",
           .about = "whether a PNG is, byte by byte, what this version draws",
           .rights = {Right::render},
           .pace = Pace::in_turn,
           .handler = post_verify,
           .answers = {verdict()},
           .gives = {media::json},
           .body = png_body()}};
}

}  // namespace tia::server
