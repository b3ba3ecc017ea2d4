#include "server/requests/film_plan.h"

#include <algorithm>
#include <cmath>

#include "core/input/json.h"
#include "core/video/vp9.h"
#include "core/video/webp_animation.h"
#include "server/requests/film_frames.h"
#include "server/requests/recipe.h"
#include "server/stores/digest.h"

namespace tia::server {
namespace {

int frames_before(double seconds, double fps) {
  return static_cast<int>(std::min(std::ceil(seconds * fps), 2 * Animation::most_frames));
}

// Errors: InputError where the scene has no such times, or too many.
void choose_frames(const FilmRequest& asked, const Animation& animation, const Limits& limits,
                   FilmPlan& film) {
  const auto check = [&](const char* pointer, const std::optional<double>& seconds) {
    if (seconds && *seconds > animation.duration)
      throw InputError({FaultKind::out_of_range, pointer, Value(*seconds),
                        range_text(Spec{.unit = "s", .min = 0, .max = animation.duration}, false)});
  };
  check("/from", asked.from);
  check("/to", asked.to);
  film.fps = asked.fps.value_or(animation.fps);
  if (film.fps < FilmRequest::slowest_fps)
    throw InputError({FaultKind::out_of_range, "/fps", Value(film.fps),
                      "frames that last at most " + to_json(Value(1 / FilmRequest::slowest_fps)) +
                          " s; the animation's do not"});
  film.first = frames_before(asked.from.value_or(0), film.fps);
  film.frames = frames_before(asked.to.value_or(animation.duration), film.fps) - film.first;
  if (film.frames < 1)
    throw InputError({FaultKind::out_of_range, "/from", write_value(asked.from),
                      "a time after which there is a frame; they are " +
                          to_json(Value(1 / film.fps)) + " s apart"});
  if (film.frames > limits.max_frames)
    throw InputError({FaultKind::limit, asked.fps ? "/fps" : "/to",
                      Value(std::to_string(film.frames) + " frames"),
                      "at most " + std::to_string(limits.max_frames) +
                          " frames (option TIA_MAX_FRAMES); from, to and fps choose them"});
}

// A scene that does not move has no times.
void check_still(const FilmRequest& asked) {
  const auto check = [](const char* pointer, const std::optional<double>& given) {
    if (given)
      throw InputError({FaultKind::conflict, pointer, Value(*given),
                        "a scene with an animation or physics; this one does not move"});
  };
  check("/from", asked.from);
  check("/to", asked.to);
}

// Errors: InputError where a frame does not go with the first one.
void check_same(const Plan& plan, FilmPlan& film, int frame) {
  const int width = plan.window.width(), height = plan.window.height();
  const bool clear = is_transparent(*plan.scene, plan.options.integrator);
  if (frame == 0) {
    film.width = width;
    film.height = height;
    film.is_transparent = clear;
  }
  if (width == film.width && height == film.height && clear == film.is_transparent) return;
  throw InputError({FaultKind::conflict, "/scene/animation",
                    Value("another size or kind at " + to_json(Value(film.seconds_of(frame))) +
                          " s than at the first frame"),
                    "frames of one size, with alpha or without"});
}

// H.264 halves the sides for its colours.
void check_mp4(const FilmPlan& film, const RenderContext& context) {
  const auto refuse = [](const char* allowed) {
    throw InputError({FaultKind::conflict, "/format", Value("mp4"), allowed});
  };
  if (context.ffmpeg.program.empty())
    refuse(
        "another format: mp4 takes the program ffmpeg, which this server has none of (option "
        "TIA_FFMPEG)");
  if (film.width % 2 != 0 || film.height % 2 != 0) refuse("another format, or even sides");
}

// Errors: InputError where the format cannot have such frames.
void check_format(const FilmRequest& asked, const FilmPlan& film, const RenderContext& context) {
  const FilmFormatRow& row = row_of(asked.film_format);
  const auto names = [](const auto& fits) {
    std::vector<std::string_view> all;
    for (const FilmFormatRow& each : film_formats)
      if (fits(each)) all.push_back(each.name);
    return listed(all);
  };
  if (film.is_transparent && !row.has_alpha)
    throw InputError({FaultKind::conflict, "/format", write_value(asked.film_format),
                      names([](auto& each) { return each.has_alpha; }) +
                          ", which have alpha, or a backdrop that is a colour"});
  if (asked.film_format == FilmFormat::mp4) check_mp4(film, context);
  const int side = std::max(film.width, film.height);
  if (side > row.longest_side)
    throw InputError({FaultKind::conflict, "/format", write_value(asked.film_format),
                      names([&](auto& each) { return side <= each.longest_side; }) +
                          ", or sides of at most " + std::to_string(row.longest_side) + " pixels"});
}

void check_film_rays(double rays, const FilmPlan& film, const Limits& limits) {
  if (rays <= static_cast<double>(limits.max_rays)) return;
  throw InputError({FaultKind::limit, "/samples",
                    Value(std::to_string(film.frames) + " frames that take " +
                          to_json(Value(rays)) + " rays from the eye alone"),
                    "at most " + std::to_string(limits.max_rays) +
                        " rays of the whole film (option TIA_MAX_RAYS)"});
}

// What its bytes depend on besides its frames.
std::string version_of(FilmFormat format, const RenderContext& context) {
  std::string version(row_of(format).name);
  if (format == FilmFormat::webm) version += vp9_encoder();
  if (format == FilmFormat::webp) version += webp_encoder();
  if (format == FilmFormat::mp4) version += context.ffmpeg.program;
  return version;
}

std::string film_etag(const FilmRequest& asked, const FilmPlan& film,
                      const RenderContext& context) {
  std::string text = "film " + version_of(asked.film_format, context) + ' ' +
                     to_json(Value(film.fps)) + ' ' + std::to_string(film.first);
  for (const Shot& shot : film.shots) text += ' ' + std::to_string(shot.frames) + shot.etag;
  return etag_of(text);
}

}  // namespace

std::int64_t FilmPlan::ms_until(int frame) const {
  return static_cast<std::int64_t>(std::floor(1000 * (frame / fps) + 0.5));
}

FilmPlan film_plan_of(FilmRequest& asked, const RenderContext& context,
                      const Requester& requester) {
  FilmPlan film;
  film.scene = moving_scene_of(asked, context, requester);
  const KnownScene& scene = film.scene;
  film.moves = scene->animation.has_value();
  if (film.moves) {
    choose_frames(asked, *scene->animation, context.limits, film);
  } else {
    check_still(asked);
    film.fps = asked.fps.value_or(film.fps);
  }
  FilmFrames frames(asked, film.scene);
  for (int frame = 0; frame < film.frames; ++frame) {
    end_if_asked(requester.stop);
    const Plan plan = frames.plan_at(film.seconds_of(frame), context, requester);
    check_same(plan, film, frame);
    if (frame == 0) check_format(asked, film, context);
    std::string etag = etag_of(plan.recipe);
    if (film.shots.empty() || film.shots.back().etag != etag) {
      film.shots.push_back({frame, 0, std::move(etag)});
      check_film_rays(film.rays += plan.sure_rays(), film, context.limits);
    }
    ++film.shots.back().frames;
  }
  film.etag = film_etag(asked, film, context);
  return film;
}

}  // namespace tia::server
