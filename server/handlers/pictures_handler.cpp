// /pictures: those that are kept, by their tags.
#include "server/contract/answers.h"
#include "server/contract/parameters.h"
#include "server/contract/query_parameters.h"
#include "server/handlers/bodies.h"
#include "server/handlers/handlers.h"
#include "server/handlers/picture_response.h"
#include "server/handlers/rendered.h"
#include "server/handlers/stream_response.h"
#include "server/requests/etag.h"

namespace tia::server {
namespace {

HttpError not_kept() {
  return {"not-found", "no picture of that tag is kept, any more; ask for it where it is drawn"};
}

// As SHA-256 is written.
bool is_tag(std::string_view text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == text.npos;
}

// Waits for one that is being drawn.
Response shown_so_far(Stream stream, const std::string& etag, const Request& request,
                      Service& service) {
  check_stream(name_of(stream), request);
  const auto drawing = [etag, requester = requester_of(request), &service](const auto& see) {
    const auto found = service.pictures.find_or_join(etag, waiting_wish(requester, see, service));
    if (!found) throw not_kept();
    return *found;
  };
  return streamed(stream, etag, drawing, request, service);
}

Response get_picture(const Request& request, const std::string& name, Service& service) {
  const auto asked = read_described<KeptPictureRequest>(
      query_object<KeptPictureRequest>(request.query()), {}, request.stop);
  if (!is_tag(name)) throw not_kept();
  const std::string etag = '"' + name + '"';
  if (asked.stream) return shown_so_far(*asked.stream, etag, request, service);
  const auto found = service.pictures.find(etag);
  if (!found) throw not_kept();
  Response response = has_already(request, etag)
                          ? Response{.status = 304, .content_type = "", .body = ""}
                          : picture_response(*found, 0, 0);
  if (response.status == 304)
    response.headers.emplace_back("Cache-Status", "Tia; hit; detail=not-modified");
  response.headers.emplace_back("ETag", etag);
  // Its tag names its bytes: they never change.
  response.headers.emplace_back("Cache-Control", "public, max-age=31536000, immutable");
  return response;
}

}  // namespace

std::vector<Route> picture_routes() {
  Answer answer = shown_answer(picture_answer());
  return {{.method = "GET",
           .path = "/pictures/{}",
           .name = "get_picture",
           .about = "a picture that is kept, by its tag: also one on the way to another",
           .rights = {Right::render},
           .pace = Pace::in_turn,
           .handler = get_picture,
           .answers = {answer, picture_unchanged()},
           .query = query_parameters<KeptPictureRequest>,
           .segment = {"etag", "the picture's ETag, without the quotes"}}};
}

}  // namespace tia::server
