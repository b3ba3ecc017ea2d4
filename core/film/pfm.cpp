#include "core/film/pfm.h"

#include <bit>
#include <cstring>

namespace tia {

static_assert(std::endian::native == std::endian::little, "PFM is written little-endian");

std::string encode_pfm(const Image& image) {
  const std::string head =
      "PF\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n-1.0\n";
  std::string out = head;
  out.resize(head.size() + image.rgb.size() * sizeof(float));
  const std::size_t row = 3 * static_cast<std::size_t>(image.width) * sizeof(float);
  char* to = out.data() + head.size();
  for (int y = image.height - 1; y >= 0; --y, to += row) std::memcpy(to, image.at(0, y), row);
  return out;
}

}  // namespace tia
