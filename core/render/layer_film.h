// LayerFilm: a film for a picture with layers, which OpenEXR stores.
#pragma once

#include <string>

#include "core/film/exr.h"
#include "core/render/layers.h"

namespace tia {

/// LayerFilm: keeps linear light, unclamped, and what else is known of the pixels.
class LayerFilm {
 public:
  /// `transparent`: whether tiles have alpha; else it is 1.
  LayerFilm(int width, int height, LayerSet layers, bool transparent)
      : layers_(layers), transparent_(transparent), planes_(width, height, layers.planes()) {}

  /// The picture's own tiles: light, and the layers that come of its samples.
  void put(const FilmTile& tile);
  /// Another integrator's, for a layer that is its picture.
  void put(const FilmTile& tile, const LayerRow& feature);
  /// `head` lacks the channels; rgba's type is `of_rgba`, all other light is float.
  std::string encode(ExrHead head, ExrType of_rgba, const Workers& workers) const;

 private:
  int first_plane(Layer layer) const;

  LayerSet layers_;
  bool transparent_;
  Planes planes_;
};

}  // namespace tia
