// PixelCone: how wide what a pixel sees is.
#pragma once

namespace tia {

/// PixelCone: at a distance d along a pixel's ray it sees `width + spread * d`, in scene units; a
/// cone of 0 is a ray. Source: Akenine-Moeller et al., "Improved shader and texture level of detail
/// using ray cones", JCGT 10(1), 2021, with the side of a square of the pixel's area.
struct PixelCone {
  double width = 0, spread = 0;
};

}  // namespace tia
