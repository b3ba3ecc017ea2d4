// Animated PNG: the parts of PNG files, as frames of one.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tia {

/// ApngWriter: makes the file piece by piece, each as soon as its frame is there. What the frames
/// say of themselves in text chunks is left out.
/// Source: W3C PNG (third edition), 11.3.4 (acTL, fcTL, fdAT).
class ApngWriter {
 public:
  /// The longest that a frame may be shown. Unit: ms.
  static constexpr std::int64_t longest_ms = 65'535;

  /// `frames`: how many are to come; they are shown over and over.
  explicit ApngWriter(int frames) : frames_(frames) {}

  /// The next piece: what stands before the first frame, too. The frame is shown for `ms`/1000 s.
  /// Domain: PNG files of this program, of one size and kind; 0 <= ms <= longest_ms.
  /// Errors: InputError (malformed) for a file that is none.
  std::string frame(std::string_view png, std::int64_t ms);
  /// The last piece.
  static std::string end();

 private:
  std::string control(std::string_view header, std::int64_t ms);
  std::string data(std::string_view pixels);

  const int frames_;
  bool has_begun_ = false;
  std::uint32_t next_ = 0;  // of the sequence that fcTL and fdAT share
};

}  // namespace tia
