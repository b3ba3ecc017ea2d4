#include "core/film/hdr.h"

#include <algorithm>
#include <cstdlib>
#include <new>

#include "core/parallel/stopped.h"

namespace {

// stb takes memory for one row and does not ask whether it has got it.
void* allocate(std::size_t bytes) {
  void* const memory = std::malloc(bytes);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

#define STBIW_MALLOC(bytes) allocate(bytes)
#define STBIW_REALLOC(memory, bytes) std::realloc(memory, bytes)
#define STBIW_FREE(memory) std::free(memory)
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace tia {
namespace {

// The longest file of so many pixels: in each row four marks, and for each of the four planes its
// bytes with one mark before every 128.
std::size_t most_bytes(const Image& image) {
  constexpr std::size_t head = 160;
  const auto width = static_cast<std::size_t>(image.width);
  return head + static_cast<std::size_t>(image.height) * 4 * (width + width / 128 + 2);
}

void append(void* file, void* bytes, int count) {
  static_cast<std::string*>(file)->append(static_cast<const char*>(bytes),
                                          static_cast<std::size_t>(count));
}

}  // namespace

std::string encode_hdr(Image image, const std::stop_token& stop) {
  end_if_asked(stop);
  // Written so that NaN becomes 0.
  for (float& component : image.rgb)
    component = component > 0 ? std::min(component, largest_rgbe) : 0;
  std::string file;
  file.reserve(most_bytes(image));  // so that append throws nothing through stb
  stbi_write_hdr_to_func(append, &file, image.width, image.height, 3, image.rgb.data());
  file.shrink_to_fit();
  return file;
}

}  // namespace tia
