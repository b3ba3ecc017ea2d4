// Film: where finished blocks go. Developing a block while it is still in the cache spares a pass
// over the whole picture; blocks never overlap, so films need no lock.
#pragma once

#include "core/film/image.h"
#include "core/film/tonemap.h"

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

/// DisplayFilm: clamps to [0,1], applies the transfer curve, keeps 8-bit codes.
class DisplayFilm {
 public:
  DisplayFilm(int width, int height, Transfer transfer)
      : image_(width, height), transfer_(transfer) {}
  void put(const Block& block);
  const Image8& image() const { return image_; }

 private:
  Image8 image_;
  Transfer transfer_;
};

}  // namespace tia
