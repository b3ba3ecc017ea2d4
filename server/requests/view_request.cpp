#include "server/requests/view_request.h"

#include "core/input/object_schema.h"

namespace tia::server {

void ViewRequest::check(const Place& at, Faults& faults) const {
  Moment::check(at, faults);
  if (key && light)
    faults.add(
        {FaultKind::conflict, at.at("light").pointer(), write_value(*light), "key or light"});
}

}  // namespace tia::server
