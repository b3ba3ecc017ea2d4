#include "server/handlers/picture_response.h"

#include <cstdio>

#include "server/requests/reached.h"

namespace tia::server {
namespace {

std::string server_timing(const Timing& t) {
  char text[192];
  std::snprintf(text, sizeof text,
                "queue;dur=%.3f, wait;desc=memory;dur=%.3f, parse;dur=%.3f, build;dur=%.3f, "
                "trace;dur=%.3f, encode;dur=%.3f",
                t.queue, t.wait, t.parse, t.build, t.trace, t.encode);
  return text;
}

std::string ray_counts(const RayCounts& rays) {
  return "primary=" + std::to_string(rays.primary) + ", shadow=" + std::to_string(rays.shadow) +
         ", reflection=" + std::to_string(rays.reflection) +
         ", refraction=" + std::to_string(rays.refraction) +
         (rays.cut > 0 ? ", cut=" + std::to_string(rays.cut) : "");
}

// RFC 9211, with this server as the cache and the tracer behind it.
std::string cache_status(const PictureStore::Found& found) {
  std::string status = "Tia; ";
  if (found.source == Source::stored) return status + "hit";
  status += found.picture->rays_before > 0 ? "fwd=partial" : "fwd=miss";
  if (found.source == Source::joined) status += "; collapsed";
  return found.kept ? status + "; stored" : status;
}

}  // namespace

// A picture that was not drawn for this request took it no time, but its rays are told again.
Response picture_response(const PictureStore::Found& found, double parse_ms, double wait_ms) {
  const Picture& picture = *found.picture;
  Timing timing = found.source == Source::drawn ? picture.timing : Timing{};
  if (found.source == Source::joined) timing.queue = wait_ms;
  timing.parse = parse_ms;
  Response response{.content_type = std::string(picture.media_type),
                    .body = "",
                    .headers = {{"Server-Timing", server_timing(timing)},
                                {"Tia-Rays", ray_counts(picture.rays)},
                                {"Cache-Status", cache_status(found)}},
                    .shared = {found.picture, &picture.bytes}};
  if (picture.reached && picture.tells_reached) tell_reached(*picture.reached, response.headers);
  for (const auto& [name, value] : response.headers) response.log.emplace_back(name, value);
  // What a client need not know, but whoever runs the server may.
  if (picture.degenerate > 0)
    response.log.emplace_back("triangles without area", static_cast<double>(picture.degenerate));
  if (picture.unasked > 0)
    response.log.emplace_back("lights met by chance", static_cast<double>(picture.unasked));
  return response;
}

}  // namespace tia::server
