// The views that a picture is made of: one, or those of a scene's sheet.
#pragma once

#include <algorithm>
#include <vector>

#include "server/requests/plan.h"

namespace tia::server {

/// Part: a view, and where its corner is in the picture.
struct Part {
  SharedScene scene;  ///< with the view's own camera and lights
  View view;
  Window window;  ///< of the view
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

/// Puts a part's tile on the film of the picture.
template <class Film>
void put(const FilmTile& tile, const Part& part, Film& film) {
  if (part.x == 0 && part.y == 0) return film.put(tile);
  FilmTile moved = tile;
  moved.x += part.x;
  moved.y += part.y;
  film.put(moved);
}

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
/// Traces all parts onto the film. `world`: the plan's scene's, whose objects all have.
/// Errors: as render's.
template <class Film>
Rendered trace_parts(PartTracing by, const World& world, Film& film) {
  Rendered all;
  const std::vector<Part> parts = parts_of(by.plan);
  for (const Part& part : parts) {
    World own;
    if (by.plan.scene->sheet)
      by.workers.alone([&] { own = compile(*part.scene, world.of_objects, by.workers); });
    const Rendered drawn =
        render(by.plan.scene->sheet ? own : world, part.view, part.window, by.options, by.pool,
               by.stop, [&](const FilmTile& tile) { put(tile, part, film); });
    add(all, drawn, static_cast<int>(&part - parts.data()));
    by.options.max_rays -= drawn.rays.all();
  }
  fill_up(by.plan, parts.back(), film);
  return all;
}

}  // namespace tia::server
