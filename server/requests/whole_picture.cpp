#include "server/requests/whole_picture.h"

namespace tia::server {

int WholePicture::view_at(int x, int y, int width, int height) const {
  const int column = x / width, row = y / height;
  for (std::size_t i = 0; i < views.views.size(); ++i)
    if (views.views[i].column == column && views.views[i].row == row) return static_cast<int>(i);
  return -1;
}

WholePicture whole_picture(const Scene& scene, int width, int height, const Limits& limits) {
  WholePicture whole;
  const auto& display = scene.camera.display;
  int columns = 1, rows = 1;
  if (scene.sheet) {
    columns = scene.sheet->columns, rows = scene.sheet->rows();
  } else {
    if (display && display->is_square() && width != height)
      throw InputError(
          {FaultKind::out_of_range, "/height", Value(height),
           "as much as width: the views of a " + std::string(display->type()) + " are squares"});
    whole.views = views_of(scene.camera, width, height);
    columns = whole.views.columns, rows = whole.views.rows;
  }
  check_size(std::int64_t{columns} * width, std::int64_t{rows} * height, limits);
  whole.size = {0, 0, columns * width, rows * height};
  return whole;
}

Window window_within(const Window& whole, const PictureRequest& asked) {
  if (!asked.crop) return whole;
  const Window window = asked.window();
  if (window.x1 > whole.x1 || window.y1 > whole.y1)
    throw InputError(
        {FaultKind::out_of_range, "/crop", write_value(asked.crop),
         "x0 < x1 <= " + std::to_string(whole.x1) + " and y0 < y1 <= " + std::to_string(whole.y1)});
  return window;
}

}  // namespace tia::server
