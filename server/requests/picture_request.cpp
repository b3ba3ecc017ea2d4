#include "server/requests/picture_request.h"

#include <algorithm>

#include "core/version.h"

namespace tia::server {
namespace {

// Where a query's + has become a space, too.
bool is_this_version(std::string text) {
  std::replace(text.begin(), text.end(), ' ', '+');
  return text == version() || text == full_version();
}

}  // namespace

void PictureRequest::check(const Place& at, Faults& faults) const {
  ViewRequest::check(at, faults);
  const Window w = window();
  if (w.x0 >= w.x1 || w.y0 >= w.y1 || w.x1 > width || w.y1 > height)
    faults.add(
        {FaultKind::out_of_range, at.at("crop").pointer(), write_value(crop),
         "x0 < x1 <= " + std::to_string(width) + " and y0 < y1 <= " + std::to_string(height)});
  if (depth_range && (*depth_range)[0] > (*depth_range)[1])
    faults.add({FaultKind::out_of_range, at.at("depth_range").pointer(), write_value(*depth_range),
                "near,far, of which far is not less than near"});
  if (v && !is_this_version(*v))
    faults.add({FaultKind::out_of_range, at.at("v").pointer(), Value(*v),
                full_version() + ", which this server draws; or none, for whatever it draws"});
}

Window PictureRequest::window() const {
  if (!crop) return {0, 0, width, height};
  return {(*crop)[0], (*crop)[1], (*crop)[2], (*crop)[3]};
}

}  // namespace tia::server
