// Colours for numbers, told apart by those who see fewer colours, too.
#pragma once

#include <array>
#include <cstdint>

namespace tia {

/// From 0 (dark blue) to 1 (yellow), evenly lighter; numbers beyond are the nearest of these.
/// Source: Smith, van der Walt, "A better default colormap for Matplotlib", SciPy 2015: viridis,
/// its 256 colours (CC0).
std::array<std::uint8_t, 3> viridis(double x);

/// One of eight colours for what has no order; from the eighth on they are those of viridis.
/// Source: Okabe, Ito, "Color universal design" (2008); Wong, Nature Methods 8 (2011), 441.
std::array<std::uint8_t, 3> categorical(std::size_t i);

}  // namespace tia
