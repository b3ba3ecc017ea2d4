// How numbers that are no light (normals, distances, ...) are shown in a picture of 8-bit codes.
#pragma once

#include "core/film/image.h"
#include "core/film/tone.h"

namespace tia {

/// FeatureDisplay: what a film's numbers mean to the eye.
enum class FeatureDisplay {
  light,   ///< linear light, by the tone
  share,   ///< a share in [0,1], as it is
  normal,  ///< 0.5 + 0.5 n; 0, which is no normal, as 0
  depth,   ///< 1 / (1 + t), so that infinity is 0
  number,  ///< a distinct colour for each of 1, 2, 3 ...; 0 as 0
  cost     ///< log2(1 + c) / 16
};

/// DisplayRule: how a picture's numbers become codes. All but light is stored linearly, for it
/// must be read back whatever the tone.
struct DisplayRule {
  FeatureDisplay shown = FeatureDisplay::light;
  Tone tone = {};
};

/// Turns a tile's numbers into what linear codes store.
void show(FeatureDisplay shown, FilmTile& tile);

}  // namespace tia
