#include "server/requests/film_request.h"

namespace tia::server {

void FilmRequest::check(const Place& at, Faults& faults) const {
  PictureRequest::check(at, faults);
  if (from && to && *from >= *to)
    faults.add({FaultKind::conflict, at.at("to").pointer(), Value(*to), "a time after from"});
}

}  // namespace tia::server
