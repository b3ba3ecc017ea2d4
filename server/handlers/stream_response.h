// Pictures that refine: the answer that shows one while it is drawn.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "server/contract/contract.h"
#include "server/handlers/service.h"
#include "server/http/message.h"
#include "server/requests/render_request.h"

namespace tia::server {

/// The picture whose drawing shows itself to `see` until then.
using ShownDrawing = std::function<PictureStore::Found(const Showing::See& see)>;

/// Where a picture is as long as it is kept. Domain: an entity tag.
std::string picture_address(std::string_view etag);

/// The answer in parts: each picture that the drawing shows, then the picture itself, whose tag is
/// `etag` where it has none of its own. A client that is slow gets fewer. What the drawing throws
/// before anything is shown is answered as ever, later it is the last event or part.
Response streamed(Stream stream, const std::string& etag, ShownDrawing drawing,
                  const Request& request, Service& service);

/// Errors: InputError (conflict) at /stream for HEAD, which no picture is drawn for, and for other
/// formats than PNG.
void check_stream(std::string_view stream, const Request& request, Format format = Format::png);

/// What the documents say of such answers.
std::vector<Content> stream_contents();

}  // namespace tia::server
