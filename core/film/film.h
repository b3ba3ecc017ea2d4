// Film: where finished blocks go. Developing a block while it is still in the cache spares a pass
// over the whole picture; blocks never overlap, so films need no lock.
#pragma once

#include "core/film/display.h"
#include "core/film/image.h"

namespace tia {

/// LinearFilm: keeps linear light, unclamped, for PFM and for whoever computes on.
class LinearFilm {
 public:
  LinearFilm(int width, int height) : image_(width, height) {}
  void put(const Block& block);
  const Image& image() const { return image_; }

 private:
  Image image_;
};

/// DisplayFilm: shows the numbers by the rule, clamps to [0,1], applies the curve, keeps 8-bit
/// codes.
class DisplayFilm {
 public:
  DisplayFilm(int width, int height, Transfer transfer)
      : DisplayFilm(width, height, DisplayRule{Shown::light, transfer}) {}
  DisplayFilm(int width, int height, const DisplayRule& rule)
      : image_(width, height), rule_(rule) {}
  void put(const Block& block);
  const Image8& image() const { return image_; }

 private:
  void develop(const Block& block);

  Image8 image_;
  DisplayRule rule_;
};

}  // namespace tia
