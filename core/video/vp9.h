// VP9 frames, by libvpx.
#pragma once

#include <memory>
#include <string>

#include "core/film/image.h"

namespace tia {

/// Vp9Frame: one that is compressed.
struct Vp9Frame {
  std::string bytes;
  bool is_key = false;  ///< whether it needs none before it
};

/// Vp9Encoder: profile 0, which every decoder has: 8 bits, 4:2:0, as YCbCr420 has them, which the
/// frames say. In one thread and at one quality, so that one version's bytes on one kind of
/// processor depend on the pictures alone.
class Vp9Encoder {
 public:
  /// Domain: sides of at most 65 535 pixels. Errors: std::bad_alloc.
  Vp9Encoder(int width, int height);
  ~Vp9Encoder();
  Vp9Encoder(const Vp9Encoder&) = delete;
  Vp9Encoder& operator=(const Vp9Encoder&) = delete;

  /// The next picture. Domain: of the encoder's size. Errors: std::bad_alloc.
  Vp9Frame encode(const Image8& image);

 private:
  struct Codec;
  const std::unique_ptr<Codec> codec_;
  std::int64_t frames_ = 0;
};

/// Its name and version, for the bytes depend on it: "libvpx v1.12.0".
std::string vp9_encoder();

}  // namespace tia
