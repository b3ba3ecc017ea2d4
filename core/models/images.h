// What the files of a model's images hold.
#pragma once

#include <memory>
#include <vector>

#include "core/film/image.h"
#include "core/input/errors.h"
#include "core/models/model.h"
#include "core/models/model_files.h"

namespace tia {

/// Whether a file begins like a PNG, a JPEG or a WebP.
bool is_image(ModelBytes file);

/// The pictures of a model's images, one an image; null for an image without a file, which no
/// texture names. All headers are looked at before anything is decoded.
/// Errors: as faults at /images/i: what is no picture or a broken one (wrong_type), and what is
/// beyond the limits: texture_side, texture_pixels of all together, and 16 times as many gone over
/// by the scans of JPEGs. Then all are null. Stopped, between two pictures, once that is asked for.
/// Cost: memory as decode_picture_rgba's and decode_webp's for one, and 4 bytes a pixel.
std::vector<std::shared_ptr<const ImageRgba8>> decode_images(const Model& model,
                                                             const ModelLimits& limits,
                                                             Faults& faults);

}  // namespace tia
