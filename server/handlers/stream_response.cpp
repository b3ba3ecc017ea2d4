#include "server/handlers/stream_response.h"

#include <new>

#include "core/input/json.h"
#include "core/parallel/stopped.h"
#include "server/handlers/mixed_parts.h"
#include "server/handlers/picture_response.h"
#include "server/http/peers.h"

namespace tia::server {
namespace {

constexpr std::string_view event_stream = "text/event-stream";

std::string event(std::string_view name, std::string_view data) {
  return std::string("event: ").append(name).append("\ndata: ").append(data).append("\n\n");
}
std::string problem_event(const std::string& document) { return event("problem", document); }

// What of a picture that is not there yet, or is: numbers that are not known are null.
std::string data_of(const Picture& picture, int round, bool is_preview, std::string_view etag) {
  Value samples, noise;
  if (const auto& reached = picture.reached) {
    samples = Value::Object{{"min", static_cast<double>(reached->least)},
                            {"mean", reached->mean},
                            {"max", static_cast<double>(reached->most)}};
    if (picture.tells_noise && !is_preview) noise = reached->noise;
  }
  return to_json(Value::Object{{"round", static_cast<double>(round)},
                               {"samples", std::move(samples)},
                               {"noise", std::move(noise)},
                               {"rays", static_cast<double>(picture.rays.all())},
                               {"preview", is_preview},
                               {"href", picture_address(etag)}});
}

/// Sending: one client's stream.
class Sending {
 public:
  Sending(Stream stream, const SendPart& send) : stream_(stream), send_(send) {}

  /// Never throws: others see the picture, too. Whoever has left is told elsewhere.
  void show(const SeenPicture& seen) noexcept try {
    round_ = seen.round + 1;
    if (stream_ == Stream::events)
      return send_.latest(
          event("round", data_of(*seen.picture, seen.round, seen.is_preview, seen.picture->etag)));
    begin();
    send_.latest(part({seen.picture}, seen.picture->etag, seen.is_preview));
  } catch (const Stopped&) {
  } catch (const std::bad_alloc&) {  // then it sees a later one
  }
  void end(const PictureStore::Found& found, const std::string& etag) {
    if (stream_ == Stream::events)
      return send_.latest(event("done", data_of(*found.picture, round_, false, etag)));
    begin();
    send_.latest(part(found, etag, false, true));
  }

 private:
  void begin() {
    if (!has_begun_) send_(mixed_parts::begin());
    has_begun_ = true;
  }
  // With the fields that an answer with that picture has.
  static std::string part(const PictureStore::Found& found, std::string_view etag, bool is_preview,
                          bool is_last = false) {
    const Response answer = picture_response(found, 0, 0);
    Headers fields{{"ETag", std::string(etag)}};
    fields.insert(fields.end(), answer.headers.begin(), answer.headers.end());
    if (is_preview) fields.emplace_back("Tia-Preview", "true");
    return mixed_parts::part(answer.content_type, fields, found.picture->bytes, is_last);
  }

  const Stream stream_;
  const SendPart& send_;
  bool has_begun_ = false;
  int round_ = 0;  // how many have come
};

}  // namespace

std::string picture_address(std::string_view etag) {
  return "/pictures/" + std::string(etag.substr(1, etag.size() - 2));  // without its quotes
}

Response streamed(Stream stream, const std::string& etag, ShownDrawing drawing,
                  const Request& request, Service& service) {
  Response response{.content_type = std::string(stream == Stream::events ? event_stream
                                                                         : mixed_parts::media_type),
                    .body = ""};
  response.headers = {{"Cache-Control", "no-store"}, {"X-Accel-Buffering", "no"}};
  response.problem_part = stream == Stream::events ? problem_event : mixed_parts::problem;
  response.parts = [stream, etag, drawing = std::move(drawing), client = share_of(request.peer),
                    &service](const SendPart& send) {
    MemoryClaim claim(service.memory, client);
    const ClaimScope scope(&claim);
    Sending sending(stream, send);
    const auto found = drawing([&](const SeenPicture& seen) { sending.show(seen); });
    sending.end(found, found.picture->etag.empty() ? etag : found.picture->etag);
  };
  return response;
}

void check_stream(std::string_view stream, const Request& request, Format format) {
  const auto refuse = [&](const char* allowed) {
    throw InputError({FaultKind::conflict, "/stream", Value(stream), allowed});
  };
  if (request.is_head()) refuse("GET or POST, which have a picture drawn");
  if (format != Format::png) refuse("png, the format that pictures are shown in on their way");
}

std::vector<Content> stream_contents() {
  std::vector<Content> contents{{event_stream}, {mixed_parts::media_type}};
  for (Content& each : contents) each.headers = {"X-Accel-Buffering"};
  return contents;
}

}  // namespace tia::server
