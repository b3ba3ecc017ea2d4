#include "server/http/error.h"

namespace tia::server {

HttpError uri_too_long() {
  return {"uri-too-long", "a URL may have " + std::to_string(longest_target) +
                              " bytes; send the parameters as a JSON object with POST /render"};
}

}  // namespace tia::server
