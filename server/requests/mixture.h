// Pictures that are mixed of several views: anaglyphs, panels of lenses.
#pragma once

#include <vector>

#include "core/film/image.h"
#include "core/render/window.h"
#include "core/scene/displays/view_grid.h"

namespace tia::server {

/// Mixture: what has come of the views so far. Any thread may add tiles of one view, which do not
/// overlap; views come one after the other, so that sums have one order.
class Mixture {
 public:
  /// `alpha`: whether tiles have it; the mixture's is the greatest.
  Mixture(const Window& window, bool alpha);

  /// The sum, and what the view's tile adds to it: below 0 where least squares leave that.
  FilmTile with(const FilmTile& tile, const Mix& mix) const;
  /// Keeps that.
  void add(const FilmTile& tile, const Mix& mix);

 private:
  Image sum_;
  std::vector<float> alpha_;  // or none
};

}  // namespace tia::server
