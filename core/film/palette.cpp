#include "core/film/palette.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace tia {
namespace {

constexpr std::string_view viridis_table =
    "44015444025645045745055946075a46085c460a5d460b5e470d60470e614710634711644713654814674816684817"
    "69"
    "48186a481a6c481b6d481c6e481d6f481f70482071482173482374482475482576482677482878482979472a7a472c"
    "7a"
    "472d7b472e7c472f7d46307e46327e46337f463480453581453781453882443983443a83443b84433d84433e85423f"
    "85"
    "4240864241864142874144874045884046883f47883f48893e49893e4a893e4c8a3d4d8a3d4e8a3c4f8a3c508b3b51"
    "8b"
    "3b528b3a538b3a548c39558c39568c38588c38598c375a8c375b8d365c8d365d8d355e8d355f8d34608d34618d3362"
    "8d"
    "33638d32648e32658e31668e31678e31688e30698e306a8e2f6b8e2f6c8e2e6d8e2e6e8e2e6f8e2d708e2d718e2c71"
    "8e"
    "2c728e2c738e2b748e2b758e2a768e2a778e2a788e29798e297a8e297b8e287c8e287d8e277e8e277f8e27808e2681"
    "8e"
    "26828e26828e25838e25848e25858e24868e24878e23888e23898e238a8d228b8d228c8d228d8d218e8d218f8d2190"
    "8d"
    "21918c20928c20928c20938c1f948c1f958b1f968b1f978b1f988b1f998a1f9a8a1e9b8a1e9c891e9d891f9e891f9f"
    "88"
    "1fa0881fa1881fa1871fa28720a38620a48621a58521a68522a78522a88423a98324aa8325ab8225ac8226ad8127ad"
    "81"
    "28ae8029af7f2ab07f2cb17e2db27d2eb37c2fb47c31b57b32b67a34b67935b77937b87838b9773aba763bbb753dbc"
    "74"
    "3fbc7340bd7242be7144bf7046c06f48c16e4ac16d4cc26c4ec36b50c46a52c56954c56856c66758c7655ac8645cc8"
    "63"
    "5ec96260ca6063cb5f65cb5e67cc5c69cd5b6ccd5a6ece5870cf5773d05675d05477d1537ad1517cd2507fd34e81d3"
    "4d"
    "84d44b86d54989d5488bd6468ed64590d74393d74195d84098d83e9bd93c9dd93ba0da39a2da37a5db36a8db34aadc"
    "32"
    "addc30b0dd2fb2dd2db5de2bb8de29bade28bddf26c0df25c2df23c5e021c8e020cae11fcde11dd0e11cd2e21bd5e2"
    "1a"
    "d8e219dae319dde318dfe318e2e418e5e419e7e419eae51aece51befe51cf1e51df4e61ef6e620f8e621fbe723fde7"
    "25";
constexpr std::size_t colors = viridis_table.size() / 6;
static_assert(colors == 256);

constexpr std::uint8_t digit(char c) {
  return static_cast<std::uint8_t>(c <= '9' ? c - '0' : c - 'a' + 10);
}
std::array<std::uint8_t, 3> color_at(std::size_t i) {
  std::array<std::uint8_t, 3> code{};
  for (std::size_t k = 0; k < 3; ++k)
    code[k] = static_cast<std::uint8_t>(digit(viridis_table[6 * i + 2 * k]) * 16 +
                                        digit(viridis_table[6 * i + 2 * k + 1]));
  return code;
}

}  // namespace

std::array<std::uint8_t, 3> viridis(double x) {
  const double last = static_cast<double>(colors - 1);
  return color_at(static_cast<std::size_t>(std::floor(std::clamp(x, 0.0, 1.0) * last + 0.5)));
}

std::array<std::uint8_t, 3> categorical(std::size_t i) {
  using Code = std::array<std::uint8_t, 3>;
  constexpr std::array<Code, 8> codes{Code{0, 114, 178},   Code{230, 159, 0},  Code{0, 158, 115},
                                      Code{204, 121, 167}, Code{86, 180, 233}, Code{213, 94, 0},
                                      Code{240, 228, 66},  Code{120, 120, 120}};
  if (i < codes.size()) return codes[i];
  return color_at((i * 97) % colors);
}

}  // namespace tia
