#include "core/film/hdr.h"

#include <algorithm>
#include <cstdlib>
#include <new>
#include <utility>

#include "core/parallel/stopped.h"

namespace {

// What stb has taken for one row. It does not ask whether it has got it, and would not give it back
// where the work is stopped within the picture.
thread_local void* row = nullptr;

void release() { std::free(std::exchange(row, nullptr)); }

void* allocate(std::size_t bytes) {
  release();
  row = std::malloc(bytes);
  if (row == nullptr) throw std::bad_alloc();
  return row;
}

}  // namespace

#define STBIW_MALLOC(bytes) allocate(bytes)
#define STBIW_REALLOC(memory, bytes) std::realloc(memory, bytes)
#define STBIW_FREE(memory) release()
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

/// File: what is written so far, and when it was last asked whether to go on.
struct File {
  std::string text = {};
  const std::stop_token& stop;
  std::size_t asked_at = 0;

  static void append(void* to, void* bytes, int count) {
    constexpr std::size_t often = 1 << 16;
    File& file = *static_cast<File*>(to);
    file.text.append(static_cast<const char*>(bytes), static_cast<std::size_t>(count));
    if (file.text.size() < file.asked_at + often) return;
    file.asked_at = file.text.size();
    end_if_asked(file.stop);
  }
};

struct Release {
  ~Release() { release(); }
};

}  // namespace

std::string encode_hdr(Image image, const std::stop_token& stop) {
  const Release at_the_end;
  for (int y = 0; y < image.height; ++y) {
    end_if_asked(stop);
    // Written so that NaN becomes 0.
    for (float *c = image.at(0, y), *end = c + 3 * image.width; c < end; ++c)
      *c = *c > 0 ? std::min(*c, largest_rgbe) : 0;
  }
  File file{.stop = stop};
  file.text.reserve(most_bytes(image));
  stbi_write_hdr_to_func(File::append, &file, image.width, image.height, 3, image.rgb.data());
  file.text.shrink_to_fit();
  return std::move(file.text);
}

}  // namespace tia
