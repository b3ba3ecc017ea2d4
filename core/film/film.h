// Film: where finished tiles go. Developing a tile while it is still in the cache spares a pass
// over the whole picture; tiles never overlap, so films need no lock.
#pragma once

#include <atomic>
#include <utility>
#include <vector>

#include "core/film/display.h"
#include "core/film/image.h"
#include "core/film/scanlines.h"

namespace tia {

/// LinearFilm: keeps linear light, unclamped, for PFM, HDR and for whoever computes on.
class LinearFilm {
 public:
  LinearFilm(int width, int height) : image_(width, height) {}
  void put(const FilmTile& tile);
  const Image& image() const& { return image_; }
  Image image() && { return std::move(image_); }

 private:
  Image image_;
};

/// Development: how a film makes codes of tiles.
class Development {
 public:
  explicit Development(const DisplayRule& rule) : shown_(rule.shown), tone_(rule.tone) {}
  /// Writes the tile's codes, from the first of its corner on.
  void operator()(const FilmTile& tile, std::uint8_t* to, std::size_t row_bytes) const;

 private:
  FeatureDisplay shown_;
  ToneMap tone_;
};

/// DisplayFilm: shows the numbers by the rule, clamps to [0,1], encodes them, keeps 8-bit codes.
class DisplayFilm {
 public:
  DisplayFilm(int width, int height, Transfer transfer)
      : DisplayFilm(width, height, DisplayRule{FeatureDisplay::light, {transfer}}) {}
  DisplayFilm(int width, int height, const DisplayRule& rule)
      : image_(width, height), develop_(rule) {}
  void put(const FilmTile& tile);
  const Image8& image() const { return image_; }

 private:
  Image8 image_;
  Development develop_;
};

/// AlphaFilm: DisplayFilm's codes with alpha, of tiles that have it. Light is divided by alpha
/// before it is shown; where that is 0 all codes are. Alpha is stored linearly.
class AlphaFilm {
 public:
  AlphaFilm(int width, int height, const DisplayRule& rule);
  void put(const FilmTile& tile);
  const ImageRgba8& image() const { return image_; }

 private:
  ImageRgba8 image_;
  Development develop_;
};

/// ScanlineFilm: DisplayFilm's codes as the scanlines of a PNG. Who brings the last tile of a band
/// filters its rows, still in the cache, while others trace.
/// Domain: tiles in bands: those of equal y are equally high.
class ScanlineFilm {
 public:
  ScanlineFilm(int width, int height, const DisplayRule& rule)
      : scanlines_(width, height), develop_(rule), come_(static_cast<std::size_t>(height)) {}
  void put(const FilmTile& tile);
  /// Complete once every pixel has been put.
  const Scanlines& scanlines() const { return scanlines_; }

 private:
  Scanlines scanlines_;
  Development develop_;
  std::vector<std::atomic<int>> come_;  // pixels of each band, counted in its first row
};

}  // namespace tia
