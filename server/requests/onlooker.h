// Who looks on while a picture is drawn.
#pragma once

#include <functional>

#include "server/stores/showing.h"

namespace tia::server {

/// Onlooker: who wants to see a picture while it is drawn.
struct Onlooker {
  std::function<bool()> wants;             ///< whether what there is now is to be made a picture
  std::function<void(SeenPicture)> takes;  ///< which has a tag of its own
};

}  // namespace tia::server
