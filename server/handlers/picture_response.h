// What the answer with a picture says of it.
#pragma once

#include "server/http/message.h"
#include "server/stores/picture_store.h"

namespace tia::server {

/// The answer: the picture's bytes, how long this request took, the rays, what was reached.
/// `parse_ms`, `wait_ms`: the request's own times; the latter where it joined another's picture.
Response picture_response(const PictureStore::Found& found, double parse_ms, double wait_ms);

}  // namespace tia::server
