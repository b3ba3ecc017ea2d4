// WebM: VP9 frames in a file that can be sent while it is made.
#pragma once

#include <cstdint>
#include <string>

#include "core/video/vp9.h"

namespace tia {

/// WebmWriter. Its Segment and Clusters do not tell their sizes, as in every live stream; how long
/// it lasts is known before. Colours are told in the track: BT.709's primaries and matrix, sRGB's
/// curve, the narrow range.
/// Source: RFC 8794 (EBML), RFC 9559 (Matroska), WebM Container Guidelines.
class WebmWriter {
 public:
  WebmWriter(int width, int height, std::int64_t duration_ms)
      : width_(width), height_(height), duration_ms_(duration_ms) {}

  /// What stands before the first frame.
  std::string head() const;
  /// The next frame, which is shown from then on. Domain: times ascend; the first is a key.
  std::string frame(const Vp9Frame& frame, std::int64_t at_ms);

 private:
  std::string track() const;

  const int width_, height_;
  const std::int64_t duration_ms_;
  std::int64_t cluster_ms_ = -1;  // where the cluster begins; -1: there is none
};

}  // namespace tia
