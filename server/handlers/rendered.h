// The answer to whoever asks for a picture, however its scene was found.
#pragma once

#include "server/contract/contract.h"
#include "server/handlers/service.h"
#include "server/http/message.h"
#include "server/operation/timing.h"
#include "server/requests/render_request.h"

namespace tia::server {

/// AskedPicture: what is asked for, and whether Accept has chosen the format.
struct AskedPicture {
  PictureRequest picture;
  bool accepted = false;
};

/// The picture, from the cache or drawn, or that the client has it. HEAD and If-None-Match need no
/// ray: what the picture is called is known. `watch` has run since the request came.
/// Errors: as plan_of, picture_of.
Response rendered(const AskedPicture& asked, Stopwatch watch, const Request& request,
                  Service& service);

/// The picture while it is drawn. Errors: as plan_of; check_stream.
Response shown_while_drawn(PictureRequest asked, Stream stream, const Request& request,
                           Service& service);
/// The scene as it is changed, in JPEGs. Errors: as plan_of, check_stream, LiveStreams::take.
Response shown_live(RenderRequest asked, const Request& request, Service& service);

/// What such an answer is, as the documents have it; and that the client has it already.
Answer picture_answer();
Answer picture_unchanged();
/// The same of an answer that may be a stream.
Answer shown_answer(Answer answer);

}  // namespace tia::server
