#include "server/picture.h"

#include <algorithm>

#include "server/stopwatch.h"

namespace tia::server {

void PictureRequest::check(const Place& at, Faults& faults) const {
  if (key && light)
    faults.add(
        {FaultKind::conflict, at.at("light").pointer(), write_value(*light), "key or light"});
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

Scene scene_of(const PictureRequest& asked, const Gallery& gallery) {
  const auto* name = std::get_if<std::string>(&asked.scene);
  const Scene& scene =
      name != nullptr ? gallery.scene(*name, "/scene") : std::get<Scene>(asked.scene);
  if (asked.key) return press(scene, *asked.key);
  if (asked.light) return with_light(scene, *asked.light);
  return scene;
}

Picture draw(const PictureRequest& asked, const Studio& studio, const std::stop_token& stop) {
  Picture picture;
  Stopwatch watch;
  check_size(asked.width, asked.height, studio.limits);
  const Scene scene = scene_of(asked, studio.gallery);
  picture.timing.parse = watch.lap_ms();

  const World world = compile(scene);
  const View view = view_of(scene.camera, asked.width, asked.height);
  const Window window = asked.window();
  const RenderOptions options{
      .integrator =
          asked.integrator.value_or(scene.options.integrator.value_or(IntegratorName::thesis)),
      .threads = std::min(asked.threads.value_or(studio.pool.threads()), studio.pool.threads())};
  picture.timing.build = watch.lap_ms();

  const auto trace_onto = [&](auto& film) {
    picture.rays = render(world, view, window, options, studio.pool, stop,
                          [&](const Block& block) { film.put(block); });
    picture.timing.trace = watch.lap_ms();
  };
  if (asked.format == Format::pfm) {
    LinearFilm film(window.width(), window.height());
    trace_onto(film);
    picture.bytes = encode_pfm(film.image());
  } else {
    DisplayFilm film(window.width(), window.height(),
                     asked.transfer.value_or(scene.options.transfer));
    trace_onto(film);
    picture.bytes = encode_png(film.image());
  }
  picture.media_type = media_type_of(asked.format);
  picture.timing.encode = watch.lap_ms();
  return picture;
}

}  // namespace tia::server
