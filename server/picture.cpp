#include "server/picture.h"

#include <algorithm>

#include "core/integrators/shown.h"
#include "server/stopwatch.h"

namespace tia::server {

void PictureRequest::check(const Place& at, Faults& faults) const {
  ViewRequest::check(at, faults);
  const Window w = window();
  if (w.x0 >= w.x1 || w.y0 >= w.y1 || w.x1 > width || w.y1 > height)
    faults.add(
        {FaultKind::out_of_range, at.at("crop").pointer(), write_value(crop),
         "x0 < x1 <= " + std::to_string(width) + " and y0 < y1 <= " + std::to_string(height)});
}

Window PictureRequest::window() const {
  if (!crop) return {0, 0, width, height};
  return {(*crop)[0], (*crop)[1], (*crop)[2], (*crop)[3]};
}

std::string_view media_type_of(Format format) {
  return format == Format::pfm ? "image/x-portable-floatmap" : "image/png";
}

Plan plan_of(const PictureRequest& asked, const Studio& studio) {
  check_size(asked.width, asked.height, studio.limits);
  Plan plan{scene_of(asked, studio), asked.window(), {}, {}};
  RenderOptions& options = plan.options;
  options = options_of(asked, *plan.scene, studio);
  options.threads = std::min(asked.threads.value_or(studio.pool.threads()), studio.pool.threads());
  plan.display = {shown(options.integrator), asked.transfer.value_or(plan.scene->options.transfer)};
  const Window& window = plan.window;
  check_rays(static_cast<std::int64_t>(window.width()) * window.height(),
             least_samples(options.samples, options.threshold), studio.limits);
  return plan;
}

Picture draw(const PictureRequest& asked, const Studio& studio, const std::stop_token& stop) {
  Picture picture;
  Stopwatch watch;
  const Plan plan = plan_of(asked, studio);
  picture.timing.parse = watch.lap_ms();

  const World world = compile(*plan.scene);
  const View view = view_of(plan.scene->camera, asked.width, asked.height);
  picture.degenerate = world.degenerate;
  picture.timing.build = watch.lap_ms();

  const auto trace_onto = [&](auto& film) {
    picture.rays = render(world, view, plan.window, plan.options, studio.pool, stop,
                          [&](const Block& block) { film.put(block); });
    picture.timing.trace = watch.lap_ms();
  };
  if (asked.format == Format::pfm) {
    LinearFilm film(plan.window.width(), plan.window.height());
    trace_onto(film);
    picture.bytes = encode_pfm(film.image());
  } else {
    DisplayFilm film(plan.window.width(), plan.window.height(), plan.display);
    trace_onto(film);
    picture.bytes = encode_png(film.image());
  }
  picture.media_type = media_type_of(asked.format);
  picture.timing.encode = watch.lap_ms();
  return picture;
}

}  // namespace tia::server
