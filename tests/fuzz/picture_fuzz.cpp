// Any bytes as a picture that is sent back, and as the text chunk of one: what is read has been
// there, and all that goes wrong is an InputError.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/film/png.h"
#include "core/film/png_chunk.h"
#include "core/film/png_text.h"
#include "server/requests/recipe.h"

namespace {

using namespace tia;

constexpr std::size_t most_bytes = 1 << 20;  // to which a thousandth of it may unpack

void must(bool holds) {
  if (!holds) std::abort();
}

void read(std::string_view png) {
  try {
    server::Config config;
    config.max_body_bytes = most_bytes;
    const auto text = text_in(png, server::recipe_keyword, most_bytes);
    must(!text || text->size() <= most_bytes);
    const server::Recipe recipe = server::read_recipe(server::recipe_text_in(png, config), config);
    must(text && to_json(parse_json(*text)).find(to_json(Value(recipe.version))) != text->npos);
  } catch (const InputError& error) {
    must(!error.faults().empty() && *error.what() != '\0');
  }
}

// The bytes as the data of a chunk, whose checksum no fuzzer would find.
std::string with_chunk(std::string_view data) {
  std::string png = encode_png(Image8(1, 1));
  return png.insert(png_signature.size() + 25, png_chunk("iTXt", data));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  read(bytes);
  read(with_chunk(bytes));
  const std::string png = with_text(encode_png(Image8(1, 1)), server::recipe_keyword, bytes);
  if (size <= most_bytes) must(text_in(png, server::recipe_keyword, most_bytes) == bytes);
  return 0;
}
