#include "core/models/ply_colors.h"

#include "core/film/tonemap.h"

namespace tia {
namespace {

constexpr std::size_t ply_codes(PlyType type) { return type == PlyType::uint8 ? 256 : 65536; }

double ply_signal(PlyType type, double code) {
  return code / static_cast<double>(ply_codes(type) - 1);
}

}  // namespace

float PlyColors::linear(PlyType type, double stored) {
  if (!is_whole(type)) return static_cast<float>(stored);
  std::vector<float>& known = type == PlyType::uint8 ? of_bytes_ : of_words_;
  if (known.empty()) known.assign(ply_codes(type), -1);
  float& light = known[static_cast<std::size_t>(stored)];
  if (light < 0) light = static_cast<float>(srgb_to_linear(ply_signal(type, stored)));
  return light;
}

float PlyColors::alpha(PlyType type, double stored) {
  return static_cast<float>(is_whole(type) ? ply_signal(type, stored) : stored);
}

}  // namespace tia
