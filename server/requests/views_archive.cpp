#include "server/requests/views_archive.h"

#include <algorithm>

#include "core/film/png.h"
#include "core/input/codec.h"
#include "core/input/json.h"
#include "core/video/stored_zip.h"

namespace tia::server {
namespace {

// The pixels of a view, of `channels` codes each.
std::vector<std::uint8_t> cut(const std::vector<std::uint8_t>& from, int width, int channels,
                              const Window& place) {
  const auto bytes = [&](int pixels) { return static_cast<std::ptrdiff_t>(pixels) * channels; };
  std::vector<std::uint8_t> codes;
  codes.reserve(static_cast<std::size_t>(bytes(place.width()) * place.height()));
  for (int y = place.y0; y < place.y1; ++y) {
    const auto row = from.begin() + bytes(width) * y;
    codes.insert(codes.end(), row + bytes(place.x0), row + bytes(place.x1));
  }
  return codes;
}
Image8 cut(const Image8& from, const Window& place) {
  Image8 view;
  view.width = place.width(), view.height = place.height();
  view.rgb = cut(from.rgb, from.width, 3, place);
  return view;
}
ImageRgba8 cut(const ImageRgba8& from, const Window& place) {
  return {place.width(), place.height(), cut(from.rgba, from.width, 4, place)};
}

Value window_value(const Vec3d& center, const Vec3d& right, const Vec3d& up) {
  return Value::Object{
      {"center", write_value(center)}, {"right", write_value(right)}, {"up", write_value(up)}};
}

// Where an eye or a module is, from the middle of a wall's screen.
void tell_screen(const View& view, const ModuleImage& wall, const Vec3d& eye, Value::Object& to) {
  to.emplace_back("eye", write_value(view.origin + eye));
  to.emplace_back("window", window_value(view.origin, view.right * wall.half_width,
                                         view.up * wall.half_height));
}

// Where a view's eye is, and the window that it looks through.
void tell_place(const View& view, double depth, Value::Object& to) {
  if (const auto* image = std::get_if<ModuleImage>(&view.curved))
    return tell_screen(view, *image, view.right * image->module + view.axis * image->behind, to);
  if (const auto* slice = std::get_if<ModuleSlice>(&view.curved))
    return tell_screen(view, slice->wall,
                       view.right * slice->viewer + view.up * slice->wall.eye_height -
                           view.axis * slice->wall.distance,
                       to);
  to.emplace_back("eye", write_value(view.origin));
  if (!view.is_flat()) return;
  const double scale = depth / dot(view.forward, view.axis);
  const double grown = view.orthographic() ? 1 : scale;
  to.emplace_back("window", window_value(view.origin + view.forward * scale, view.right * grown,
                                         view.up * grown));
}

std::string views_json(const Plan& plan) {
  Value::Array all;
  for (const GridView& of : plan.views.views) {
    Value::Object told{{"file", plan.is_mixed() ? "mixed.png" : of.name + ".png"},
                       {"column", of.column},
                       {"row", of.row}};
    tell_place(of.view, plan.views.window_depth, told);
    all.emplace_back(std::move(told));
  }
  return to_json(Value::Object{{"columns", plan.views.columns},
                               {"rows", plan.views.rows},
                               {"width", plan.view.width},
                               {"height", plan.view.height},
                               {"views", std::move(all)}});
}

template <class AnyImage>
std::string archive_of(const Plan& plan, const AnyImage& image, const std::stop_token& stop) {
  StoredZip zip;
  std::string bytes = zip.file("views.json", views_json(plan));
  const int width = plan.view.width, height = plan.view.height;
  for (const GridView& of : plan.views.views) {
    const int x = of.column * width, y = of.row * height;
    const std::string name = plan.is_mixed() ? "mixed" : of.name;
    bytes += zip.file(name + ".png", encode_png(cut(image, {x, y, x + width, y + height}), stop));
    if (plan.is_mixed()) break;
  }
  return bytes + zip.end();
}

}  // namespace

std::string views_archive(const Plan& plan, const Image8& image, const std::stop_token& stop) {
  return archive_of(plan, image, stop);
}
std::string views_archive(const Plan& plan, const ImageRgba8& image, const std::stop_token& stop) {
  return archive_of(plan, image, stop);
}

}  // namespace tia::server
