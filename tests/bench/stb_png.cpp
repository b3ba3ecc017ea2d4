#include "tests/bench/stb_png.h"

#include <cstdlib>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace tia::bench {

std::size_t stb_png_bytes(const Image8& image) {
  int bytes = 0;
  unsigned char* png = stbi_write_png_to_mem(image.rgb.data(), 3 * image.width, image.width,
                                             image.height, 3, &bytes);
  std::free(png);
  return static_cast<std::size_t>(bytes);
}

}  // namespace tia::bench
