#include "server/requests/studio.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/film/film.h"
#include "core/film/png.h"
#include "server/http/error.h"
#include "server/requests/draw_memory.h"
#include "server/requests/parts.h"
#include "server/requests/picture_encoding.h"
#include "server/requests/recipe.h"

namespace tia::server {
namespace {

// From now on. Errors: as render(); HttpError (budget) where there is no time for one round;
// InputError where there are no rays for it.
class BudgetOfRequest {
 public:
  BudgetOfRequest(const PictureRequest& asked, int blur_steps)
      : asked_(asked), first_round_(std::max(Sampler::first_round, blur_steps)) {}

  RenderOptions options_of(const Plan& plan) const {
    RenderOptions options = plan.options;
    if (!asked_.has_budget()) return options;
    Budget& budget = options.budget.emplace();
    if (asked_.max_rays) budget.max_rays = *asked_.max_rays;
    if (asked_.budget_ms)
      budget.has_time = [start = Clock::now(), ms = *asked_.budget_ms](double more) {
        const std::chrono::duration<double, std::milli> taken = Clock::now() - start;
        return taken.count() * (1 + more) < ms;
      };
    return options;
  }
  [[noreturn]] void refuse(const BudgetSpent& spent) const {
    if (spent.of() == BudgetSpent::Of::rays)
      throw InputError({FaultKind::limit, "/max_rays", write_value(*asked_.max_rays),
                        "more than a first round of " + std::to_string(first_round_) +
                            " samples a pixel takes: from the eye alone " +
                            std::to_string(std::int64_t{first_round_} * asked_.window().width() *
                                           asked_.window().height())});
    throw HttpError("budget",
                    "budget_ms of " + std::to_string(*asked_.budget_ms) +
                        " was over before each pixel had the " + std::to_string(first_round_) +
                        " samples of a first round; ask for more time or fewer pixels",
                    {{"Retry-After", "1"}});
  }

 private:
  using Clock = std::chrono::steady_clock;
  const PictureRequest& asked_;
  int first_round_;  // samples
};

// The recipe of what has been drawn where the budget's end has decided that.
std::string recipe_of_reached(const Plan& plan, int samples) {
  Plan reached = plan;
  reached.in_effect.samples = samples;
  if (samples == reached.in_effect.usual_samples()) reached.in_effect.samples = std::nullopt;
  return recipe_of(*plan.asked, reached);
}

// The file of a film, each kind in its own way.
std::string file_of(const ExrPicture& film, const PictureEncoding& encode) {
  return film.encode(encode.recipe, encode.workers);
}
std::string file_of(LinearFilm film, const PictureEncoding& encode) {
  return encode(std::move(film).image());
}
std::string file_of(const ScanlineFilm& film, const PictureEncoding& encode) {
  return encode(film.scanlines());
}
std::string file_of(const DisplayFilm& film, const PictureEncoding& encode) {
  return encode(film.image());
}
std::string file_of(const AlphaFilm& film, const PictureEncoding& encode) {
  return encode(film.image());
}

}  // namespace

Studio::Studio(const Plan& plan, const RenderContext& context, const std::stop_token& stop,
               const Onlooker* onlooker)
    : plan_(plan),
      context_(context),
      stop_(stop),
      onlooker_(onlooker),
      flow_(plan.options.flow != nullptr ? *plan.options.flow : own_),
      workers_(context.pool.workers(plan.options.threads, stop, &flow_)) {}

template <class Film>
void Studio::draw_on(Film film, const Worlds& worlds, Picture& picture) {
  const Nanoseconds before = flow_.attained;
  trace(film, worlds, picture);
  if constexpr (std::is_same_v<Film, ExrPicture>) draw_features(film, worlds, picture);
  std::string recipe = plan_.recipe;
  if (plan_.asked->has_budget())
    workers_.alone([&] {
      recipe = recipe_of_reached(plan_, picture.reached->samples);
      picture.etag = etag_of(recipe);
    });
  tell_reached(picture);
  picture.timing.trace = watch_.lap_ms();
  picture.trace_seconds = static_cast<double>(flow_.attained - before) * 1e-9;
  make_file(std::move(film), recipe, picture);
}

template <class Film>
void Studio::trace(Film& film, const Worlds& worlds, Picture& picture) {
  const BudgetOfRequest budget(*plan_.asked, plan_.options.blur_steps);
  PartTracing by{plan_, budget.options_of(plan_), context_.pool, workers_, stop_};
  if constexpr (!std::is_same_v<Film, ScanlineFilm>)
    if (onlooker_ != nullptr)
      by.options.watch = [&](const Glimpse& glimpse) { show(glimpse, film); };
  try {
    const Rendered drawn = trace_parts(by, worlds, film);
    picture.rays = drawn.rays;
    picture.rays_before = drawn.before.all();
    picture.reached = drawn.reached;
  } catch (const BudgetSpent& spent) {
    budget.refuse(spent);
  }
}

void Studio::draw_features(ExrPicture& film, const Worlds& worlds, Picture& picture) {
  World of_frame;
  const bool has_own = plan_.exposure.blurs() && ExrPicture::shows_own_time(plan_);
  if (has_own) of_frame = context_.geometries.compile(plan_.scene, workers_);
  for (const FilmPart& part : parts_of(plan_)) {
    const auto instants = instants_of(part, worlds, plan_.exposure);
    const Instant frame{has_own ? of_frame : worlds.front(), part.own};
    picture.rays +=
        film.draw_features(picture.reached, part, instants, frame, context_.pool, stop_);
  }
}

template <class Film>
void Studio::make_file(Film&& film, const std::string& recipe, Picture& picture) const {
  picture.bytes = file_of(std::forward<Film>(film), {plan_, workers_, stop_, recipe});
  picture.media_type = media_type_of(plan_.format);
}

// Where nobody counts, each pixel has all its samples, but by a threshold: then that is not known.
void Studio::tell_reached(Picture& picture) const {
  const int all = plan_.options.samples;
  if (!picture.reached && plan_.options.threshold == 0)
    picture.reached = Reached{all, all, static_cast<double>(all), 1, all};
  tell_errors(picture);
}

void Studio::tell_errors(Picture& picture) const {
  picture.tells_reached = plan_.options.noise > 0 || plan_.asked->has_budget();
  const bool is_counted = picture.tells_reached || onlooker_ != nullptr;
  picture.tells_noise = is_counted && row_of(plan_.options.integrator).is_chance() &&
                        plan_.options.threshold == 0 && plan_.options.samples > 1;
}

// What there is after some rounds is the picture of as many samples, unless each pixel may have
// had more or fewer, or one sample would go elsewhere, or some times have had none yet: then it is
// nothing that can be asked for.
// The film is that of the picture, which later tiles are put on, too.
template <class Film>
void Studio::show(const Glimpse& glimpse, Film& film) {
  const int round = seen_++;
  if (!onlooker_->wants()) return;
  Picture picture;
  picture.reached = glimpse.show([&](const FilmTile& tile) { film.put(tile); });
  picture.rays = glimpse.rays;
  picture.rays_before = glimpse.before.all();
  Stopwatch so_far = watch_;
  picture.timing.trace = so_far.lap_ms();
  tell_errors(picture);
  std::string recipe;
  workers_.alone([&] {
    if (!glimpse.is_preview && plan_.options.threshold == 0 &&
        picture.reached->samples >= plan_.options.blur_steps)
      recipe = recipe_of_reached(plan_, picture.reached->samples);
    picture.etag =
        etag_of(recipe.empty() ? plan_.recipe + " seen " + std::to_string(round) : recipe);
  });
  make_file(std::as_const(film), recipe, picture);
  onlooker_->takes(
      {std::make_shared<const Picture>(std::move(picture)), round, glimpse.is_preview});
}

// ScanlineFilm takes each tile once.
void Studio::draw_on_a_film(const Worlds& worlds, Picture& picture) {
  const int width = plan_.window.width(), height = plan_.window.height();
  if (plan_.format == Format::exr) return draw_on(ExrPicture(plan_), worlds, picture);
  if (!holds_codes(plan_.format) || plan_.takes_light)
    return draw_on(LinearFilm(width, height), worlds, picture);
  if (is_transparent(*plan_.scene, plan_.options.integrator))
    return draw_on(AlphaFilm(width, height, plan_.display), worlds, picture);
  const bool is_one_file = plan_.format == Format::png;
  if (is_cut_in_strips(width, height) && onlooker_ == nullptr && !plan_.takes_codes && is_one_file)
    return draw_on(ScanlineFilm(width, height, plan_.display), worlds, picture);
  draw_on(DisplayFilm(width, height, plan_.display), worlds, picture);
}

Picture Studio::picture(const CompileWorlds& compile_worlds) {
  Picture picture;
  const Worlds worlds = compile_worlds(workers_);
  reserve_memory(memory_of(plan_, onlooker_ != nullptr), "this picture", stop_);
  picture.degenerate = worlds.front().degenerate;
  if (plan_.options.integrator == IntegratorName::path)
    picture.unasked = worlds.front().of_objects->unasked.count;
  picture.timing.build = watch_.lap_ms();
  draw_on_a_film(worlds, picture);
  picture.timing.encode = watch_.lap_ms();
  return picture;
}

}  // namespace tia::server
