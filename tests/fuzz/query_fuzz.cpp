// Any text as a query: it becomes the object that a POST would send, which can be written as a
// query and read again; all that goes wrong is an InputError.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/input/described.h"
#include "core/input/json.h"
#include "server/contract/parameters.h"
#include "server/requests/picture_request.h"

namespace {

using namespace tia;
using namespace tia::server;

void must(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const Value object = query_object<PictureRequest>({reinterpret_cast<const char*>(data), size});
    const auto asked = read_described<PictureRequest>(object);
    must(asked.width >= 1 && asked.height >= 1);
    const auto again = read_described<PictureRequest>(parse_json(to_json(object)));
    must(again.window() == asked.window() && again.seed == asked.seed);
    must(again.samples == asked.samples && again.threshold == asked.threshold);
  } catch (const InputError& error) {
    must(!error.faults().empty() && *error.what() != '\0');
  }
  return 0;
}
