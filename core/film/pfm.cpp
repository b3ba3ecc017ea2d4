#include "core/film/pfm.h"

#include <bit>

#include "core/parallel/stopped.h"

namespace tia {

static_assert(std::endian::native == std::endian::little, "PFM is written little-endian");

std::string encode_pfm(const Image& image, const std::stop_token& stop) {
  const std::string head =
      "PF\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n-1.0\n";
  const std::size_t row = 3 * static_cast<std::size_t>(image.width) * sizeof(float);
  std::string out;
  out.reserve(head.size() + image.rgb.size() * sizeof(float));
  out += head;
  for (int y = image.height - 1; y >= 0; --y) {
    end_if_asked(stop);
    out.append(reinterpret_cast<const char*>(image.at(0, y)), row);
  }
  return out;
}

}  // namespace tia
