// Tone: from linear light to what a display shows, before it becomes codes: exposure, white
// balance, and the curve. Files of linear light (PFM, HDR) have none of it.
#pragma once

#include <optional>

#include "core/film/image.h"
#include "core/film/tonemap.h"
#include "core/math/transform.h"

namespace tia {

/// Tone: how light is shown.
struct Tone {
  Transfer transfer = Transfer::srgb;
  double exposure = 0;  ///< stops: light is shown 2^exposure times as bright
  std::optional<double> white_balance_kelvin = {};  ///< the white that is shown neutral; none: D65

  bool operator==(const Tone&) const = default;
};

/// ToneMap: a tone, prepared. In double, by operations that every processor rounds alike.
///
/// `aces` is Stephen Hill's fit of the Academy's reference rendering and output transforms (RRT and
/// ODT, 2016) for sRGB, without further exposure: a middle grey of 0.18 is shown as 0.106.
/// `agx` is Troy Sobotka's AgX (2022), base look, its curve as Benjamin Wrensch's polynomial of
/// degree 6: what it gives is stored as it is, a display's power of 2.2 being part of it.
/// Source: BakingLab, ACES.hlsl; B. Wrensch, "Minimal AgX implementation", iolite-engine.com, 2023.
class ToneMap {
 public:
  explicit ToneMap(const Tone& tone);

  /// Whether light is encoded as it is.
  bool is_plain() const { return is_plain_; }
  /// How what `developed` gives is to be stored.
  Encoding encoding() const {
    return transfer_ == Transfer::srgb || transfer_ == Transfer::aces ? Encoding::srgb
                                                                      : Encoding::linear;
  }
  /// What is to be encoded. Returns: what a float holds, below 0 and above 1 too; of NaN 0.
  Vec3d developed(const Vec3d& light) const;
  /// The same encoded, before it is rounded to codes. Returns: each in [0,1].
  Vec3d signal(const Vec3d& light) const;

 private:
  Affine grade_;  // exposure and white balance
  Transfer transfer_;
  bool is_plain_;
};

/// Turns a tile's light into what is to be encoded.
void develop(const ToneMap& tone, FilmTile& tile);

}  // namespace tia
