#include "server/requests/compare_request.h"

#include <algorithm>
#include <cstring>

#include "core/film/display.h"
#include "core/input/object_schema.h"
#include "core/render/gaze_frame.h"
#include "server/requests/draw.h"

namespace tia::server {
namespace {

/// Band: of eccentricities. Unit: degrees.
struct Band {
  double from, to;
};
constexpr std::array bands{Band{0, 5}, Band{5, 15}, Band{15, 35}, Band{35, 180}};

int band_at(double eccentricity) {
  for (std::size_t i = 0; i + 1 < bands.size(); ++i)
    if (eccentricity < bands[i].to * (pi / 180)) return static_cast<int>(i);
  return static_cast<int>(bands.size()) - 1;
}

Value told(const std::optional<double>& number) { return number ? Value(*number) : Value(); }

Value band_told(const Band& band, const Similarity& of) {
  return Value::Object{{"from", band.from},
                       {"to", band.to},
                       {"pixels", write_value(of.pixels)},
                       {"mse", of.mse},
                       {"psnr_db", told(of.psnr_db())},
                       {"ssim", told(of.ssim)}};
}

void check_compared(const PictureRequest& asked, const Place& at, Faults& faults) {
  if (asked.format != Format::png)
    faults.add({FaultKind::conflict, at.at("format").pointer(), write_value(asked.format),
                "png, for what a display shows is compared"});
  if (asked.frame_ms)
    faults.add({FaultKind::conflict, at.at("frame_ms").pointer(), Value(*asked.frame_ms),
                "gaze_rays, which always gives the same picture"});
}

// Rows of one tile's width, as films show them.
void show_row(const DisplayRule& rule, const ToneMap& tone, float* rgb, int count) {
  FilmTile tile;
  tile.width = count, tile.height = 1;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    tile.r[i] = rgb[3 * i], tile.g[i] = rgb[3 * i + 1], tile.b[i] = rgb[3 * i + 2];
  show(rule.shown, tile);
  const bool is_light = rule.shown == FeatureDisplay::light;
  const auto within = [](float x) { return x > 0 ? std::min(x, 1.0F) : 0; };  // of NaN 0
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const Vec3f numbers{tile.r[i], tile.g[i], tile.b[i]};
    const Vec3f shown =
        is_light ? static_cast<Vec3f>(tone.signal(static_cast<Vec3d>(numbers))) : numbers;
    rgb[3 * i] = within(shown.x), rgb[3 * i + 1] = within(shown.y),
            rgb[3 * i + 2] = within(shown.z);
  }
}

}  // namespace

void CompareRequest::check(const Place& at, Faults& faults) const {
  const Place at_a = at.at("a"), at_b = at.at("b");
  check_compared(*a, at_a, faults);
  check_compared(*b, at_b, faults);
}

std::optional<std::array<double, 2>> CompareRequest::gaze_in_effect() const {
  return gaze ? gaze : a->gaze ? a->gaze : b->gaze;
}

Plan light_plan_of(const PictureRequest& asked, const char* pointer, const RenderContext& context,
                   const Requester& requester) {
  Plan plan = at_pointer(pointer, [&] { return plan_of(asked, context, requester); });
  plan.takes_light = true;
  return plan;
}

Image shown_signals(const Plan& plan, Picture&& picture, const Workers& workers) {
  Image image(plan.window.width(), plan.window.height());
  std::memcpy(image.rgb.data(), picture.bytes.data(), picture.bytes.size());
  picture.bytes = {};
  const ToneMap tone(plan.display.tone);
  workers.for_each(image.height, [&](int y) {
    for (int x = 0; x < image.width; x += FilmTile::size)
      show_row(plan.display, tone, image.at(x, y), std::min(FilmTile::size, image.width - x));
  });
  return image;
}

Value compared(const CompareRequest& asked, const Plan& plan_a, const Image& a, const Image& b,
               const std::stop_token& stop) {
  const auto gaze = asked.gaze_in_effect();
  std::function<int(int, int)> band_of = nullptr;
  if (gaze)
    band_of = [&plan_a, frame = GazeFrame(plan_a.view, (*gaze)[0], (*gaze)[1])](int x, int y) {
      const Window& window = plan_a.window;
      return band_at(frame.eccentricity(frame.toward(window.x0 + x + 0.5, window.y0 + y + 0.5)));
    };
  const int classes = gaze ? static_cast<int>(bands.size()) : 0;
  const Similarities all = similarity_of(a, b, classes, band_of, stop);
  Value::Array told_bands;
  for (std::size_t i = 0; i < all.classes.size(); ++i)
    told_bands.push_back(band_told(bands[i], all.classes[i]));
  return Value::Object{{"mse", all.whole.mse},
                       {"psnr_db", told(all.whole.psnr_db())},
                       {"ssim", told(all.whole.ssim)},
                       {"max", all.whole.max},
                       {"bands", std::move(told_bands)}};
}

Value comparison_schema(Definitions& named) {
  return schema_called("comparison", named, [] {
    const Value number = plain_schema<double>(), count = plain_schema<std::int64_t>();
    const Value or_null = nullable_schema(number);
    const Value band =
        object_schema({{"from", number, "degrees from the gaze"},
                       {"to", number, "degrees from the gaze, which are no more of the band"},
                       {"pixels", count, "how many it has"},
                       {"mse", number, "of its pixels"},
                       {"psnr_db", or_null, "the same; null where they are equal"},
                       {"ssim", or_null,
                        "the mean over the windows whose centre it has; null where it has none"}});
    return object_schema(
        {{"mse", number,
          "the mean squared difference of the channels as they are shown, in 0 to 1"},
         {"psnr_db", or_null, "the peak signal-to-noise ratio; null where they are equal"},
         {"ssim", or_null,
          "the mean structural similarity (Wang et al. 2004) of the luma; null of "
          "pictures smaller than its window of 11 x 11"},
         {"max", number, "the largest difference of a channel"},
         {"bands", list_schema(band), "by the angle from the gaze; none without one"}});
  });
}

}  // namespace tia::server
