// Any bytes as a connection's: however they are cut, the same requests come out, and whatever they
// ask for is answered, with a problem document where it cannot be given.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "server/handlers/backend.h"
#include "server/handlers/dispatch.h"
#include "tests/server/http/reader_support.h"

namespace {

using namespace tia;
using namespace tia::server;

void must(bool holds) {
  if (!holds) std::abort();
}

constexpr std::int64_t most_body = 2000;

// Service: one that gives little.
struct Service {
  Config config = [] {
    Config little;
    little.max_pixels = 64;
    little.max_rays = 10'000;
    little.max_work = 1'000'000;
    little.max_scenes_bytes = 1 << 20;
    little.max_geometry_bytes = 1 << 20;
    return little;
  }();
  Gallery gallery;
  Backend backend{config, gallery};
};

void expect_an_answer(const Request& request) {
  static Service little;
  const Response response = answer(request, little.backend.service);
  must(response.status >= 200 && response.status < 600 && response.status != 500);
  if (response.status >= 400) must(response.content_type == "application/problem+json");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const test::ReadOut whole = test::read_whole(bytes, most_body);
  must(test::read_pieces(test::single_bytes(bytes), most_body) == whole);
  std::mt19937 random(static_cast<unsigned>(std::hash<std::string_view>{}(bytes)));
  for (int i = 0; i < 4; ++i)
    must(test::read_pieces(test::random_pieces(bytes, random), most_body) == whole);

  RequestReader reader(most_body);
  reader.feed(bytes);
  try {
    while (reader.read() == RequestReader::State::whole) expect_an_answer(reader.take());
  } catch (const HttpError&) {
  }
  return 0;
}
