#include "server/requests/picture_encoding.h"

#include <bit>

#include "core/film/png.h"
#include "core/film/png_text.h"
#include "server/requests/linear_file.h"
#include "server/requests/recipe.h"
#include "server/requests/view_texts.h"
#include "server/requests/views_archive.h"

namespace tia::server {
namespace {

static_assert(std::endian::native == std::endian::little, "floats are told from their low end");

template <class Work>
std::string alone(const Workers& workers, const Work& work) {
  std::string bytes;
  workers.alone([&] { bytes = work(); });
  return bytes;
}
std::string with_recipe(std::string png, const PictureEncoding& by) {
  if (by.recipe.empty()) return png;
  return alone(by.workers, [&] {
    return with_view_texts(with_text(std::move(png), recipe_keyword, by.recipe), by.plan);
  });
}

}  // namespace

std::string PictureEncoding::operator()(Image light) const {
  if (plan.takes_codes || plan.takes_light)
    return {reinterpret_cast<const char*>(light.rgb.data()), light.rgb.size() * sizeof(float)};
  return alone(workers, [&] { return linear_file(plan, std::move(light), stop); });
}

std::string PictureEncoding::operator()(const Scanlines& rows) const {
  return with_recipe(encode_png(rows, workers), *this);
}

std::string PictureEncoding::operator()(const Image8& codes) const {
  if (plan.takes_codes) return {codes.rgb.begin(), codes.rgb.end()};
  if (plan.format == Format::zip)
    return alone(workers, [&] { return views_archive(plan, codes, stop); });
  if (is_cut_in_strips(codes.width, codes.height)) return (*this)(scanlines_of(codes, workers));
  return with_recipe(alone(workers, [&] { return encode_png(codes, stop); }), *this);
}

std::string PictureEncoding::operator()(const ImageRgba8& codes) const {
  if (plan.takes_codes) return {codes.rgba.begin(), codes.rgba.end()};
  if (plan.format == Format::zip)
    return alone(workers, [&] { return views_archive(plan, codes, stop); });
  return with_recipe(alone(workers, [&] { return encode_png(codes, stop); }), *this);
}

}  // namespace tia::server
