// THE LIST of building materials to radio waves. A new one is one row here.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "core/input/fields.h"

namespace tia {

/// ItuRow: eta = a f^b - j c f^d / (omega eps0), f in GHz, measured from `low_ghz` to `high_ghz`.
struct ItuRow {
  std::string_view name;
  double a, b, c, d;
  double low_ghz, high_ghz;
};

/// Source: Recommendation ITU-R P.2040-3 (2023), table 3.
inline constexpr std::array<ItuRow, 14> itu_rows{{
    {"concrete", 5.24, 0, 0.0462, 0.7822, 1, 100},
    {"brick", 3.91, 0, 0.0238, 0.16, 1, 40},
    {"plasterboard", 2.73, 0, 0.0085, 0.9395, 1, 100},
    {"wood", 1.99, 0, 0.0047, 1.0718, 0.001, 100},
    {"glass", 6.31, 0, 0.0036, 1.3394, 0.1, 100},
    {"ceiling_board", 1.48, 0, 0.0011, 1.0750, 1, 100},
    {"chipboard", 2.58, 0, 0.0217, 0.7800, 1, 100},
    {"plywood", 2.71, 0, 0.33, 0, 1, 40},
    {"marble", 7.074, 0, 0.0055, 0.9262, 1, 60},
    {"floorboard", 3.66, 0, 0.0044, 1.3515, 50, 100},
    {"metal", 1, 0, 1e7, 0, 1, 100},
    {"very_dry_ground", 3, 0, 0.00015, 2.52, 1, 10},
    {"medium_dry_ground", 15, -0.1, 0.035, 1.63, 1, 10},
    {"wet_ground", 30, -0.4, 0.15, 1.30, 1, 10},
}};

/// ItuMaterial: the number of a row.
enum class ItuMaterial : unsigned char {};
template <>
struct Names<ItuMaterial> {
  static constexpr auto names = [] {
    std::array<std::string_view, itu_rows.size()> all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = itu_rows[i].name;
    return all;
  }();
};
constexpr const ItuRow& row_of(ItuMaterial material) {
  return itu_rows[static_cast<std::size_t>(material)];
}

}  // namespace tia
