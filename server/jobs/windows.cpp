#include "server/jobs/windows.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "server/requests/picture_encoding.h"

namespace tia::server {

bool can_be_cut(const Plan& plan) {
  return !plan.options.denoise && !plan.options.gaze && !plan.scene->sheet &&
         plan.format != Format::exr && plan.format != Format::zip;
}

Window Windows::window(int n) const {
  const int x = whole.x0 + n % columns() * side, y = whole.y0 + n / columns() * side;
  return {x, y, std::min(x + side, whole.x1), std::min(y + side, whole.y1)};
}

namespace {
bool has_codes_with_alpha(const Plan& plan) {
  return plan.format == Format::png && is_transparent(*plan.scene, plan.options.integrator);
}
}  // namespace

std::size_t piece_pixel_bytes(const Plan& plan) {
  if (plan.format != Format::png) return 3 * sizeof(float);
  return has_codes_with_alpha(plan) ? 4 : 3;
}

Mosaic::Mosaic(const Plan& plan) : plan_(plan), pixel_(piece_pixel_bytes(plan)) {
  const int width = plan.window.width(), height = plan.window.height();
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (plan.format != Format::png) {
    light_ = Image(width, height);
    bytes_ = reinterpret_cast<char*>(light_.rgb.data());
  } else if (has_codes_with_alpha(plan)) {
    codes_with_alpha_ = {width, height, std::vector<std::uint8_t>(4 * pixels)};
    bytes_ = reinterpret_cast<char*>(codes_with_alpha_.rgba.data());
  } else {
    codes_ = Image8(width, height);
    bytes_ = reinterpret_cast<char*>(codes_.rgb.data());
  }
}

void Mosaic::put(const Window& window, const std::string& piece) {
  const std::size_t row = pixel_ * static_cast<std::size_t>(window.width()),
                    whole_row = pixel_ * static_cast<std::size_t>(plan_.window.width());
  if (piece.size() != row * static_cast<std::size_t>(window.height()))
    throw std::runtime_error("a piece that does not fit its window");
  char* to = bytes_ + whole_row * static_cast<std::size_t>(window.y0 - plan_.window.y0) +
             pixel_ * static_cast<std::size_t>(window.x0 - plan_.window.x0);
  for (std::size_t from = 0; from < piece.size(); from += row, to += whole_row)
    std::memcpy(to, piece.data() + from, row);
}

std::string Mosaic::file(const Workers& workers) && {
  const PictureEncoding encoding{plan_, workers, workers.stop(), plan_.recipe};
  if (plan_.format != Format::png) return encoding(std::move(light_));
  return has_codes_with_alpha(plan_) ? encoding(codes_with_alpha_) : encoding(codes_);
}

// The mean is of whole samples, which are counted again.
void ReachedOfWindows::add(const Reached& window, const Window& of) {
  const double pixels = static_cast<double>(of.width()) * of.height();
  samples_ += std::floor(window.mean * pixels + 0.5);
  pixels_ += pixels;
  if (!all_) {
    all_ = window;
  } else {
    all_->least = std::min(all_->least, window.least);
    all_->most = std::max(all_->most, window.most);
    all_->noise = std::max(all_->noise, window.noise);
    all_->samples = std::max(all_->samples, window.samples);
  }
  all_->mean = samples_ / pixels_;
}

}  // namespace tia::server
