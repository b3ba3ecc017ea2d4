#include "tests/server/requests/recipe_support.h"

#include <algorithm>

#include "tests/core/film/files.h"
#include "tests/core/film/png_chunks.h"
#include "tests/core/png/inflate.h"

namespace tia::test {
namespace {

const std::string chunk_start("Tia recipe\0\1\0\0\0", 15);  // keyword, compressed, no language

bool is_recipe(const Chunk& chunk) {
  return chunk.type == "iTXt" && chunk.data.starts_with("Tia recipe");
}

std::string file_of(const std::vector<Chunk>& chunks) {
  std::string file("\x89PNG\r\n\x1A\n");
  for (const Chunk& each : chunks) file += png_chunk(each.type, each.data);
  return file;
}

}  // namespace

std::string recipe_text(const std::string& png) {
  for (const Chunk& chunk : chunks_of(png)) {
    if (!is_recipe(chunk)) continue;
    EXPECT_EQ(chunk.data.substr(0, chunk_start.size()), chunk_start);
    return inflated(chunk.data.substr(chunk_start.size()), 1 << 22);
  }
  ADD_FAILURE() << "a picture without a recipe";
  return "";
}

std::string with_recipe(const std::string& png, const std::string& text) {
  std::vector<Chunk> chunks = chunks_of(png);
  for (Chunk& chunk : chunks)
    if (is_recipe(chunk)) chunk.data = chunk_start + zlib(text);
  return file_of(chunks);
}

std::string without_recipe(const std::string& png) {
  std::vector<Chunk> chunks = chunks_of(png);
  std::erase_if(chunks, is_recipe);
  return file_of(chunks);
}

}  // namespace tia::test
