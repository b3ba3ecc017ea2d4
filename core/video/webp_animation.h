// Animated WebP, lossless, by libwebp.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace tia {

/// WebpAnimation: pictures that are shown over and over. Its file begins with its size: so it is
/// there when all of it is. Same pictures, same bytes, of one version of libwebp.
class WebpAnimation {
 public:
  /// Domain: sides of at most 16 383 pixels. Errors: std::bad_alloc.
  WebpAnimation(int width, int height);
  ~WebpAnimation();
  WebpAnimation(const WebpAnimation&) = delete;
  WebpAnimation& operator=(const WebpAnimation&) = delete;

  /// The next picture, shown from then on: the codes of its rows, three a pixel, or with alpha
  /// four. Domain: times ascend, below 2^31 ms. Errors: std::bad_alloc.
  void add(const std::uint8_t* codes, bool has_alpha, std::int64_t at_ms);
  /// The file. Errors: std::bad_alloc.
  std::string finish(std::int64_t end_ms);

 private:
  struct Encoder;
  const std::unique_ptr<Encoder> encoder_;
};

/// Its name and version, for the bytes depend on it: "libwebp 1.2.4".
std::string webp_encoder();

}  // namespace tia
