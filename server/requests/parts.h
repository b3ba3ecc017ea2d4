// The views that a picture is made of: one, its camera's display's, or those of a scene's sheet.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "server/requests/mixture.h"
#include "server/requests/plan.h"

namespace tia::server {

/// FilmPart: a view, and where its corner is on the film.
struct FilmPart {
  std::vector<SharedScene> scenes;  ///< the exposure's, with the view's own camera and lights
  std::vector<View> views;          ///< of them
  View own;                         ///< of the plan's scene
  Window window;                    ///< of the view
  int x = 0, y = 0;
  std::optional<Mix> mix{};  ///< where it shares its place with others
};

/// Those whose pixels are asked for, in their order.
std::vector<FilmPart> parts_of(const Plan& plan);

/// Where the film has no view, in its pixels.
std::vector<Window> empty_places(const Plan& plan);

/// What the picture shows where nothing is, and is not lit.
Vec3f nothing_in(const Plan& plan);

/// Adds what has been drawn of one more part; `before`: of how many it is already.
void add(Rendered& all, const Rendered& more, int before);

/// A part's tile, where it is on the film.
inline FilmTile moved(FilmTile tile, const FilmPart& part) {
  tile.x += part.x;
  tile.y += part.y;
  return tile;
}

/// Puts a part's tile on the film of the picture.
template <class Film>
void put(const FilmTile& tile, const FilmPart& part, Film& film) {
  if (part.x == 0 && part.y == 0) return film.put(tile);
  film.put(moved(tile, part));
}

/// What there is of a picture of `count` parts while one of them is drawn, of which `number` are
/// done; a preview, for others are not. `place`: a part's tile as the picture has it. All that is
/// given outlives it.
Glimpse of_several(const Glimpse& of_part, const std::function<FilmTile(const FilmTile&)>& place,
                   const Rendered& before, int number, int count);

/// Fills what has no view.
template <class Film>
void fill_up(const Plan& plan, Film& film) {
  constexpr int size = FilmTile::size;
  const Vec3f nothing = nothing_in(plan);
  FilmTile tile;
  tile.alpha.fill(0);
  for (const Window& empty : empty_places(plan))
    for (tile.y = empty.y0; tile.y < empty.y1; tile.y += size)
      for (tile.x = empty.x0; tile.x < empty.x1; tile.x += size) {
        tile.width = std::min(size, empty.x1 - tile.x);
        tile.height = std::min(size, empty.y1 - tile.y);
        for_each_pixel(tile, [&](const Vec3f&) { return nothing; });
        film.put(tile);
      }
}

/// PartTracing: how a picture is traced.
struct PartTracing {
  const Plan& plan;
  RenderOptions options;
  Pool& pool;
  const Workers& workers;
  const std::stop_token& stop;
};
/// What the samples of a part are of, in their order. Domain: worlds of its scenes, which outlive
/// it.
std::vector<Instant> instants_of(const FilmPart& part, const std::vector<World>& worlds,
                                 const Exposure& exposure);
/// Of a sheet's part, whose lights are its own; else none.
std::vector<World> own_worlds_of(const PartTracing& by, const FilmPart& part,
                                 const std::vector<World>& worlds);

/// Traces all parts onto the film. `worlds`: of the exposure's scenes, whose objects all have.
/// Errors: as render's.
template <class Film>
Rendered trace_parts(PartTracing by, const std::vector<World>& worlds, Film& film) {
  Rendered all;
  const std::vector<FilmPart> parts = parts_of(by.plan);
  const int count = static_cast<int>(parts.size());
  const Watch watch = by.options.watch;
  std::optional<Mixture> mixture;
  if (by.plan.is_mixed())
    mixture.emplace(by.plan.window, is_transparent(*by.plan.scene, by.options.integrator));
  for (const FilmPart& part : parts) {
    const int number = static_cast<int>(&part - parts.data());
    const std::vector<World> own = own_worlds_of(by, part, worlds);
    const auto instants = instants_of(part, own.empty() ? worlds : own, by.plan.exposure);
    const std::function<FilmTile(const FilmTile&)> place = [&](const FilmTile& tile) {
      return mixture ? mixture->with(tile, *part.mix) : moved(tile, part);
    };
    if (count > 1 && watch)
      by.options.watch = [&](const Glimpse& glimpse) {
        watch(of_several(glimpse, place, all, number, count));
      };
    const Rendered drawn =
        render(instants, part.window, by.options, by.pool, by.stop, [&](const FilmTile& tile) {
          if (!mixture) put(tile, part, film);
          else if (number + 1 < count) mixture->add(tile, *part.mix);
          else film.put(mixture->with(tile, *part.mix));
        });
    add(all, drawn, number);
    by.options.max_rays -= drawn.rays.all();
  }
  fill_up(by.plan, film);
  return all;
}

}  // namespace tia::server
