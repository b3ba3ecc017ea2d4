// The views that a picture is made of: one, or those of a scene's sheet.
#pragma once

#include <algorithm>
#include <vector>

#include "server/requests/plan.h"

namespace tia::server {

/// Part: a view, and where its corner is in the picture.
struct Part {
  std::vector<SharedScene> scenes;  ///< the exposure's, with the view's own camera and lights
  std::vector<View> views;          ///< of them
  Window window;                    ///< of the view
  int x = 0, y = 0;
};

/// All of the picture: the window that is asked for, or a sheet of whole views.
Window whole_window(const PictureRequest& asked, const Scene& scene);

/// Row by row.
std::vector<Part> parts_of(const Plan& plan);

/// What the picture shows where nothing is, and is not lit.
Vec3f nothing_in(const Plan& plan);

/// Adds what has been drawn of one more part; `before`: of how many it is already.
void add(Rendered& all, const Rendered& more, int before);

/// A part's tile, where it is in the picture.
inline FilmTile moved(FilmTile tile, const Part& part) {
  tile.x += part.x;
  tile.y += part.y;
  return tile;
}

/// Puts a part's tile on the film of the picture.
template <class Film>
void put(const FilmTile& tile, const Part& part, Film& film) {
  if (part.x == 0 && part.y == 0) return film.put(tile);
  film.put(moved(tile, part));
}

/// What there is of a sheet while one of its views is drawn, of which so many are done; a preview,
/// for others are not. All that is given outlives it.
Glimpse of_sheet(const Glimpse& of_part, const Part& part, const Rendered& before, int number,
                 const Sheet& sheet);

/// Fills up the last row of a sheet.
template <class Film>
void fill_up(const Plan& plan, const Part& last, Film& film) {
  constexpr int size = FilmTile::size;
  const int right = plan.window.width(), bottom = plan.window.height();
  const Vec3f nothing = nothing_in(plan);
  FilmTile tile;
  tile.alpha.fill(0);
  for (tile.y = last.y; tile.y < bottom; tile.y += size)
    for (tile.x = last.x + last.window.width(); tile.x < right; tile.x += size) {
      tile.width = std::min(size, right - tile.x);
      tile.height = std::min(size, bottom - tile.y);
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
std::vector<Instant> instants_of(const Part& part, const std::vector<World>& worlds,
                                 const Exposure& exposure);

/// Traces all parts onto the film. `worlds`: of the exposure's scenes, whose objects all have.
/// Errors: as render's.
template <class Film>
Rendered trace_parts(PartTracing by, const std::vector<World>& worlds, Film& film) {
  Rendered all;
  const std::vector<Part> parts = parts_of(by.plan);
  const auto& sheet = by.plan.scene->sheet;
  const Watch watch = by.options.watch;
  for (const Part& part : parts) {
    const int number = static_cast<int>(&part - parts.data());
    std::vector<World> own;
    for (std::size_t i = 0; sheet && i < worlds.size(); ++i)
      by.workers.alone(
          [&] { own.push_back(compile(*part.scenes[i], worlds[i].of_objects, by.workers)); });
    const auto instants = instants_of(part, sheet ? own : worlds, by.plan.exposure);
    if (sheet && watch)
      by.options.watch = [&](const Glimpse& glimpse) {
        watch(of_sheet(glimpse, part, all, number, *sheet));
      };
    const Rendered drawn = render(instants, part.window, by.options, by.pool, by.stop,
                                  [&](const FilmTile& tile) { put(tile, part, film); });
    add(all, drawn, number);
    by.options.max_rays -= drawn.rays.all();
  }
  fill_up(by.plan, parts.back(), film);
  return all;
}

}  // namespace tia::server
