#include "core/models/images.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <variant>

#include "core/film/decode.h"
#include "core/models/webp.h"

namespace tia {
namespace {

using ImagePointer = std::shared_ptr<const ImageRgba8>;

// Pixels of all are bounded by the model's limits alone; stb_image counts bytes as int.
PictureLimits picture_limits(const ModelLimits& limits) {
  return {std::numeric_limits<int>::max(), static_cast<std::int64_t>(limits.texture_pixels)};
}

void add_image_fault(const PictureFault& fault, const Place& at, Faults& faults) {
  if (fault.beyond_limits)
    return faults.add({FaultKind::limit, at.pointer(), Value(fault.got), fault.allowed});
  faults.add(
      {FaultKind::wrong_type, at.pointer(), Value(fault.got), "a PNG, JPEG or WebP picture"});
}

std::variant<PictureSize, PictureFault> measure_image(ModelBytes file,
                                                      const PictureLimits& limits) {
  if (is_picture(file)) return measure_picture(file, limits);
  if (is_webp(file)) return measure_webp(file, limits);
  return PictureFault{false, "bytes that begin like none", "a PNG, JPEG or WebP picture"};
}

/// ImageBudget: what is left of the limits for the images that come.
class ImageBudget {
 public:
  explicit ImageBudget(const ModelLimits& limits)
      : limits_(&limits), pixels_(limits.texture_pixels), scanned_(scans * limits.texture_pixels) {}

  std::optional<PictureFault> take(const PictureSize& size) {
    const auto side = static_cast<std::uint64_t>(std::max(size.width, size.height));
    if (side > limits_->texture_side)
      return PictureFault{
          true, std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels",
          "a texture of at most " + std::to_string(limits_->texture_side) + " pixels a side"};
    if (auto fault = take(size.pixels(), 1, "", pixels_)) return fault;
    return take(size.scanned_pixels(), scans, ", a JPEG's with each of its scans", scanned_);
  }

 private:
  // A usual progressive JPEG has ten. It takes 8 ns a pixel.
  static constexpr std::uint64_t scans = 16;

  std::optional<PictureFault> take(std::int64_t pixels, std::uint64_t times, const char* counted,
                                   std::uint64_t& left) const {
    const auto more = static_cast<std::uint64_t>(pixels);
    if (more > left)
      return PictureFault{true, std::to_string(more) + " pixels more",
                          "textures of at most " + std::to_string(times * limits_->texture_pixels) +
                              " pixels together" + counted};
    left -= more;
    return std::nullopt;
  }

  const ModelLimits* limits_;
  std::uint64_t pixels_, scanned_;
};

void measure_images(const Model& model, const ModelLimits& limits, const Place& at,
                    Faults& faults) {
  ImageBudget budget(limits);
  for (std::size_t i = 0; i < model.images.size() && !faults.full(); ++i) {
    if (model.images[i].file.empty()) continue;
    const auto measured = measure_image(model.images[i].file, picture_limits(limits));
    const auto* size = std::get_if<PictureSize>(&measured);
    const auto fault = size == nullptr ? std::get<PictureFault>(measured) : budget.take(*size);
    if (fault) add_image_fault(*fault, at.at(i), faults);
  }
}

ImagePointer decode_image(ModelBytes file, const PictureLimits& limits, const Place& at,
                          Faults& faults) {
  auto decoded = is_webp(file) ? decode_webp(file, limits) : decode_picture_rgba(file, limits);
  if (const auto* fault = std::get_if<PictureFault>(&decoded)) {
    add_image_fault(*fault, at, faults);
    return nullptr;
  }
  return std::make_shared<const ImageRgba8>(std::get<ImageRgba8>(std::move(decoded)));
}

}  // namespace

bool is_image(ModelBytes file) { return is_picture(file) || is_webp(file); }

std::vector<ImagePointer> decode_images(const Model& model, const ModelLimits& limits,
                                        Faults& faults) {
  std::vector<ImagePointer> images(model.images.size());
  const Place root, at = root.at("images");
  const std::size_t before = faults.count();
  measure_images(model, limits, at, faults);
  if (faults.count() != before) return images;
  for (std::size_t i = 0; i < images.size() && !faults.full(); ++i) {
    end_if_asked(faults.stop());
    const ModelBytes file = model.images[i].file;
    if (!file.empty()) images[i] = decode_image(file, picture_limits(limits), at.at(i), faults);
  }
  if (faults.count() != before) images.assign(images.size(), nullptr);
  return images;
}

}  // namespace tia
