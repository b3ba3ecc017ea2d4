#include "server/handlers/explanation.h"

#include <algorithm>

#include "core/input/json.h"
#include "core/render/explain.h"
#include "core/render/explain_paths.h"
#include "core/scene/labels.h"
#include "server/requests/exposure.h"
#include "server/requests/gaze_request.h"
#include "server/requests/whole_picture.h"

namespace tia::server {
namespace {

/// Explaining: one request, whose scene has been found.
struct Explaining {
  const ExplainRequest& asked;
  const KnownScene scene;  // of its own time
  const Exposure exposure;
  RenderOptions options;
  const RenderContext& context;
  const Workers& workers;

  WhichPaths which() const { return {asked.sample, asked.paths.value_or(WhichPaths{}.count)}; }
  bool by_paths() const { return options.integrator == IntegratorName::path; }
  const WholePicture whole{};  // of which a pixel is asked for
  int number = 0;              // the view that has it, and is told of
  std::size_t bytes = 0;       // of all views that have been told of, at most

  const GridView& seen() const { return whole.views.views[static_cast<std::size_t>(number)]; }
  View view(const Scene& of) const {
    const auto views = views_of(of.camera, asked.width, asked.height).views;
    return views.at(static_cast<std::size_t>(number)).view;
  }
  int column() const { return *asked.x % asked.width; }
  int row() const { return *asked.y % asked.height; }
  // Tells the pixel as one of the whole.
  void tell_view(Explanation& told) {
    bytes += told.most_bytes;
    if (bytes > longest_explanation)
      throw InputError({FaultKind::limit, "/x", Value(*asked.x),
                        "a pixel whose views are told of in at most " +
                            std::to_string(longest_explanation) + " bytes together"});
    ExplainedPixel& pixel = *told.pixel;
    if (!has_display(scene->camera) || scene->sheet) return;
    pixel.view = ExplainedView{number, seen().name, pixel.x, pixel.y};
    pixel.x = *asked.x;
    pixel.y = *asked.y;
  }
  template <class Tell>
  Value::Object alone(const Tell& tell) const {
    Value::Object told;
    workers.alone([&] { told = value_of(tell()); });
    return told;
  }
};

// A ray is of no sample, and so of the frame's own time.
Value::Object explained_ray(const Explaining& by) {
  const auto& [origin, direction] = *by.asked.ray;
  const Ray<double> ray{origin, normalize(direction)};
  World world = by.context.geometries.compile(by.scene, by.workers);
  const std::stop_token& stop = by.workers.stop();
  if (by.by_paths())
    return by.alone([&] {
      return explain_paths(*by.scene, std::move(world), ray, by.which(), by.options, stop);
    });
  return by.alone([&] { return explain(*by.scene, std::move(world), ray, by.options, stop); });
}

Value::Object explained_sample(Explaining& by) {
  const auto stratum = static_cast<std::size_t>(by.asked.sample) % by.exposure.strata.size();
  const KnownScene& scene = by.exposure.scenes[by.exposure.strata[stratum]];
  World world = by.context.geometries.compile(scene, by.workers);
  return by.alone([&] {
    Explanation told = explain(*scene, std::move(world), by.view(*scene), by.column(), by.row(),
                               by.asked.sample, by.options, by.workers.stop());
    by.tell_view(told);
    return told;
  });
}

// Paths of one pixel are told as of the same objects.
void check_same_objects(const Exposure& exposure) {
  const auto labels = object_labels(*exposure.scenes.front());
  for (const KnownScene& scene : exposure.scenes)
    if (!std::ranges::equal(labels, object_labels(*scene), {}, &ObjectLabel::name,
                            &ObjectLabel::name))
      throw InputError({FaultKind::conflict, "/blur_steps", Value(exposure.blur_steps()),
                        "1 where something comes or goes while the shutter is open, for paths are "
                        "told as of the same objects"});
}

Value::Object explained_paths(Explaining& by) {
  by.workers.alone([&] { check_same_objects(by.exposure); });
  const std::vector<World> worlds = worlds_of(by.exposure, by.context, by.workers);
  SeenWorlds seen;
  for (const std::size_t i : by.exposure.strata) {
    seen.worlds.push_back(worlds[i]);
    seen.views.push_back(by.view(*by.exposure.scenes[i]));
  }
  const auto first = static_cast<std::size_t>(by.asked.sample) % by.exposure.strata.size();
  return by.alone([&] {
    PathExplanation told =
        explain_paths(*by.exposure.scenes[by.exposure.strata[first]], std::move(seen), by.column(),
                      by.row(), by.which(), by.options, by.workers.stop());
    by.tell_view(told.ray);
    return told;
  });
}

Value mix_value(const Mix& mix) {
  Value::Array rows;
  for (const Vec3f& row : mix) rows.push_back(write_value(static_cast<Vec3d>(row)));
  return rows;
}

Value::Object explained_of_view(Explaining& by) {
  Value::Object told = by.by_paths() ? explained_paths(by) : explained_sample(by);
  if (!by.scene->sheet && by.seen().mix) told.emplace_back("mix", mix_value(*by.seen().mix));
  return told;
}

// The pixel of a view, and beside it those of the views that share its place, as the other eye's.
Value::Object explained_pixel(Explaining& by) {
  Value::Object told = explained_of_view(by);
  if (by.scene->sheet || !by.seen().mix) return told;
  const GridView& first = by.seen();
  Value::Array others;
  const int count = static_cast<int>(by.whole.views.views.size());
  while (++by.number < count)
    if (by.seen().column == first.column && by.seen().row == first.row)
      others.emplace_back(explained_of_view(by));
  if (!others.empty()) told.emplace_back("others", std::move(others));
  return told;
}

// A sheet's pixels are told as of the scene's own camera, whose view is as large as each of them.
WholePicture whole_of(const ExplainRequest& asked, const Scene& scene, const Limits& limits) {
  if (!scene.sheet) return whole_picture(scene, asked.width, asked.height, limits);
  return {{0, 0, asked.width, asked.height}, views_of(scene.camera, asked.width, asked.height)};
}

// Errors: InputError for a pixel outside of the picture, or where it has no view.
int view_asked_for(const ExplainRequest& asked, const WholePicture& whole, const Scene& scene) {
  Faults faults;
  const auto coordinate = [&](const char* name, int is, int size) {
    if (is >= size)
      faults.add({FaultKind::out_of_range, Place{}.at(name).pointer(), Value(is),
                  range_text({.unit = "pixels", .min = 0, .max = size - 1.0}, true)});
  };
  coordinate("x", *asked.x, whole.size.x1);
  coordinate("y", *asked.y, whole.size.y1);
  faults.raise();
  if (scene.sheet) return 0;
  const int number = whole.view_at(*asked.x, *asked.y, asked.width, asked.height);
  if (number < 0)
    throw InputError(
        {FaultKind::out_of_range, "/x", Value(*asked.x),
         "a pixel of one of the " + std::to_string(whole.views.views.size()) + " views"});
  return number;
}

// What is told of is what a picture for the gaze traces, too.
void check_gaze(const Explaining& by, const Requester& requester) {
  const ExplainRequest& asked = by.asked;
  const View view = by.view(*by.scene);
  const auto found = gaze_of(asked, view, {0, 0, asked.width, asked.height},
                             most_samples(by.options), by.context, requester);
  if (!found) return;
  if (has_display(by.scene->camera))
    throw InputError({FaultKind::conflict, "/gaze", write_value(asked.gaze),
                      "a picture of one view; this one's camera has a display"});
  if (asked.ray)
    throw InputError({FaultKind::conflict, "/gaze", write_value(asked.gaze),
                      "x and y; a ray of its own belongs to no picture"});
  check_fovea(found->gaze, view, *asked.x, *asked.y);
}

}  // namespace

std::string explanation_of(const ExplainRequest& asked, const Service& service,
                           const Requester& requester, Flow& flow) {
  const RenderContext& context = service.rendering;
  const FoundScene found = found_scene(asked, context, requester);
  SceneOptions in_effect = options_in_effect(found.plain->options, asked);
  Exposure exposure = exposure_of(asked, found, in_effect, context, requester);
  const Workers workers = context.pool.workers(context.pool.threads(), requester.stop, &flow);
  WholePicture whole;
  if (!asked.ray) whole = whole_of(asked, *found.plain, context.limits);
  const int number = asked.ray ? 0 : view_asked_for(asked, whole, *found.plain);
  Explaining by{asked,   found.plain, std::move(exposure), options_of(in_effect, context.limits),
                context, workers,     std::move(whole),    number};
  asked.check_rays(by.options);
  check_gaze(by, requester);
  by.options.blur_steps = by.exposure.blur_steps();
  const Value::Object told = asked.ray ? explained_ray(by) : explained_pixel(by);
  std::string text;
  workers.alone([&] { text = to_json(told); });
  return text;
}

}  // namespace tia::server
