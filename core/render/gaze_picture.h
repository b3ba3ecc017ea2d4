// A picture for one gaze: the fovea pixel by pixel, what is around it by rings of rays.
#pragma once

#include <vector>

#include "core/render/gaze_fill.h"
#include "core/render/rounds.h"
#include "core/render/trace_tile.h"
#include "core/render/window_tiles.h"

namespace tia {

/// GazePicture: of a window. What it is made of must outlive it.
class GazePicture {
 public:
  /// Domain: a shot of one instant, of a perspective view without a lens, and without layers.
  GazePicture(const WindowTiles& tiles, const Shot& shot, Scalar scalar, const Gaze& gaze);

  /// Traces it and hands over all tiles. Errors: as trace_rounds.
  void draw(const WindowTiles::Develop& develop, Tally& tally);

 private:
  struct RayOfRing {
    double turn;
    const GazeRing* ring;
    int ray;
    std::int64_t slot;
  };
  std::size_t bands() const;
  std::vector<RayOfRing> rays_of_band(std::size_t band) const;
  Target target_of(const RayOfRing& ray) const;
  void trace_band(std::size_t band, Tally& tally);
  void trace_fovea(FilmTile& tile, Tally& tally) const;
  bool is_of_fovea(const TilePixels& tile, int pixel) const;
  double spread_of(std::size_t band) const;
  ShownTile traced(TilePixels& pixels, Tally& tally) const;

  const WindowTiles& tiles_;
  const Shot& shot_;
  const Scalar scalar_;
  const Acuity acuity_;
  const GazeFrame frame_;
  const GazeFovea fovea_;
  const GazeRings rings_;
  std::vector<GazeSample> samples_;
};

}  // namespace tia
