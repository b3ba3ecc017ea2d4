#include "server/handlers/stream_response.h"

#include <new>

#include "core/input/json.h"
#include "core/parallel/stopped.h"
#include "server/handlers/picture_response.h"
#include "server/http/peers.h"

namespace tia::server {
namespace {

constexpr std::string_view event_stream = "text/event-stream";
// The boundary is in no picture: that a PNG's compressed bytes have it is less likely than that two
// tags are the same.
constexpr std::string_view mixed_replace =
    "multipart/x-mixed-replace; boundary=tia-b3c1e9f0a7d25846";
constexpr std::string_view boundary = "--tia-b3c1e9f0a7d25846";

std::string event(std::string_view name, std::string_view data) {
  return std::string("event: ").append(name).append("\ndata: ").append(data).append("\n\n");
}
std::string problem_event(const std::string& document) { return event("problem", document); }
// After a boundary, which each part ends with.
std::string last_problem(const std::string& document) {
  std::string part("Content-Type: application/problem+json\r\nContent-Length: ");
  part.append(std::to_string(document.size())).append("\r\n\r\n").append(document);
  return part.append("\r\n").append(boundary).append("--\r\n");
}

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
    send_.latest(part(found, etag, false, "--"));
  }

 private:
  // A browser shows a part once it has the boundary after it: so that is the part's.
  void begin() {
    if (!has_begun_) send_(std::string(boundary) + "\r\n");
    has_begun_ = true;
  }
  // With the fields that an answer with that picture has.
  static std::string part(const PictureStore::Found& found, std::string_view etag, bool is_preview,
                          std::string_view end = "") {
    const Response answer = picture_response(found, 0, 0);
    const std::string& picture = found.picture->bytes;
    std::string part("Content-Type: ");
    part.reserve(picture.size() + 1024);
    part.append(answer.content_type).append("\r\nContent-Length: ");
    part.append(std::to_string(picture.size())).append("\r\nETag: ").append(etag);
    for (const auto& [name, value] : answer.headers)
      part.append("\r\n").append(name).append(": ").append(value);
    if (is_preview) part.append("\r\nTia-Preview: true");
    part.append("\r\n\r\n").append(picture);
    return part.append("\r\n").append(boundary).append(end).append("\r\n");
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
  Response response{
      .content_type = std::string(stream == Stream::events ? event_stream : mixed_replace),
      .body = ""};
  response.headers = {{"Cache-Control", "no-store"}, {"X-Accel-Buffering", "no"}};
  response.problem_part = stream == Stream::events ? problem_event : last_problem;
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

void check_stream(Stream stream, const Request& request, Format format) {
  const auto refuse = [&](const char* allowed) {
    throw InputError({FaultKind::conflict, "/stream", write_value(stream), allowed});
  };
  if (request.is_head()) refuse("GET or POST, which have a picture drawn");
  if (format != Format::png) refuse("png, the format that pictures are shown in on their way");
}

std::vector<Content> stream_contents() {
  std::vector<Content> contents{{event_stream}, {mixed_replace}};
  for (Content& each : contents) each.headers = {"X-Accel-Buffering"};
  return contents;
}

}  // namespace tia::server
