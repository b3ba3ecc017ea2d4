// ImageTexture: a picture on a surface, looked up by the surface coordinates.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "core/film/image.h"
#include "core/film/tonemap.h"
#include "core/input/codec.h"
#include "core/shapes/crossing.h"

namespace tia {

/// PictureFile: a PNG or JPEG file in base64, and its pixels, which copies share.
struct PictureFile {
  std::string base64;
  std::shared_ptr<const Image8> pixels;  ///< set by reading it
  bool operator==(const PictureFile& other) const { return base64 == other.base64; }
};

/// Errors: `wrong_type` where the text is not base64 or the file no picture; `limit` where the file
/// or its picture is too large, or all pictures of the input together are.
template <>
struct Codec<PictureFile> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   PictureFile& out);
  static Value write(const PictureFile& v) { return v.base64; }
  static Value schema(const Spec&);
  static std::string allowed(const Spec&);
};

/// How colours between the centres of pixels are found.
enum class Filter { bilinear, nearest };
template <>
struct Names<Filter> {
  static constexpr std::array<std::string_view, 2> names{"bilinear", "nearest"};
};

/// ImageTexture: a picture that fills [0,1] x [0,1] of the surface coordinates, u to the right, v
/// up, and is repeated outside of it.
struct ImageTexture {
  static constexpr std::string_view type = "image";
  PictureFile data;
  Encoding transfer = Encoding::srgb;
  Filter filter = Filter::bilinear;
  std::array<double, 2> repeat{1, 1};

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("data", &ImageTexture::data,
          Spec{.about = "a PNG or JPEG file, at most 1 MiB and 4194304 pixels; all pictures of a "
                        "scene at most 16777216",
               .required = true});
    visit("transfer", &ImageTexture::transfer,
          Spec{.about = "curve from linear light to the file's codes"});
    visit("filter", &ImageTexture::filter, Spec{.about = "what stands between pixels"});
    visit("repeat", &ImageTexture::repeat,
          Spec{.about = "how many times it stands along u and v; below 0 mirrored",
               .min = -1e6,
               .max = 1e6,
               .not_zero = true});
  }
  bool operator==(const ImageTexture&) const = default;
};

struct ImageForm {
  std::shared_ptr<const Image8> pixels;
  const std::array<double, 256>* light = nullptr;  ///< the linear light of each code
  Filter filter = Filter::bilinear;
  std::array<double, 2> repeat{1, 1};
};

/// Domain: an image that was read without a fault.
ImageForm prepare(const ImageTexture& image);
/// The bytes of its picture, in full, though copies share it.
std::size_t heap_bytes(const ImageForm& form);
/// Returns: linear RGB; for `bilinear` the mean of the four pixels around, weighted by area.
Vec3d color_at(const ImageForm& form, const Vec3d& p, const Vec2d& uv, double blur);

}  // namespace tia
