#include "core/math/noise.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace tia {
namespace {

constexpr std::array<std::uint8_t, 256> permutation{
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103,
    30,  69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,
    197, 62,  94,  252, 219, 203, 117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174,
    20,  125, 136, 171, 168, 68,  175, 74,  165, 71,  134, 139, 48,  27,  166, 77,  146, 158, 231,
    83,  111, 229, 122, 60,  211, 133, 230, 220, 105, 92,  41,  55,  46,  245, 40,  244, 102, 143,
    54,  65,  25,  63,  161, 1,   216, 80,  73,  209, 76,  132, 187, 208, 89,  18,  169, 200, 196,
    135, 130, 116, 188, 159, 86,  164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250, 124,
    123, 5,   202, 38,  147, 118, 126, 255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,
    182, 189, 28,  42,  223, 183, 170, 213, 119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101,
    155, 167, 43,  172, 9,   129, 22,  39,  253, 19,  98,  108, 110, 79,  113, 224, 232, 178, 185,
    112, 104, 218, 246, 97,  228, 251, 34,  242, 193, 238, 210, 144, 12,  191, 179, 162, 241, 81,
    51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,  181, 199, 106, 157, 184, 84,  204, 176,
    115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,  222, 114, 67,  29,  24,  72,  243,
    141, 128, 195, 78,  66,  215, 61,  156, 180};

// An integer's place in the permutation, however large; NaN's is 0.
std::uint32_t wrapped(double integer) {
  const double rest = integer - 256 * std::floor(integer / 256);
  return rest > 0 ? static_cast<std::uint32_t>(rest) : 0;
}

std::uint32_t permuted(std::uint32_t i) { return permutation[i & 255U]; }

// 6t^5 - 15t^4 + 10t^3: its first and second derivatives are 0 at both ends.
double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

double lerp(double t, double a, double b) { return a + t * (b - a); }

// The dot product with one of the twelve directions to a cube's edges, four of them twice.
double slope(std::uint32_t hash, const Vec3d& p) {
  const std::uint32_t h = hash & 15U;
  const double u = h < 8 ? p.x : p.y;
  const double v = h < 4 ? p.y : h == 12 || h == 14 ? p.x : p.z;
  return ((h & 1U) == 0 ? u : -u) + ((h & 2U) == 0 ? v : -v);
}

}  // namespace

double gradient_noise(const Vec3d& p) {
  const Vec3d cell{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  const Vec3d in = p - cell;
  const Vec3d weight{fade(in.x), fade(in.y), fade(in.z)};
  const std::uint32_t x = wrapped(cell.x), y = wrapped(cell.y), z = wrapped(cell.z);
  const auto corner = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    const std::uint32_t hash = permuted(permuted(permuted(x + i) + y + j) + z + k);
    return slope(hash, in - Vec3d{double(i), double(j), double(k)});
  };
  const auto edge = [&](std::uint32_t j, std::uint32_t k) {
    return lerp(weight.x, corner(0, j, k), corner(1, j, k));
  };
  const auto face = [&](std::uint32_t k) { return lerp(weight.y, edge(0, k), edge(1, k)); };
  return lerp(weight.z, face(0), face(1));
}

double turbulence_at(const Vec3d& p) {
  double sum = 0, size = 1;
  for (int i = 0; i < turbulence_octaves; ++i) {
    sum += std::fabs(gradient_noise(p * (1 / size))) * size;
    size /= 2;
  }
  return sum;
}

}  // namespace tia
