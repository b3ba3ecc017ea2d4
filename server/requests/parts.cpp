#include "server/requests/parts.h"

#include <algorithm>

namespace tia::server {
namespace {

FilmPart part_of_sheet(const Plan& plan, const SheetView& view) {
  const int width = plan.view.width, height = plan.view.height;
  FilmPart part{{}, {}, view_of(view.camera, width, height), {0, 0, width, height}};
  for (const KnownScene& each : plan.exposure.scenes) {
    auto scene = std::make_shared<Scene>(*each);
    scene->camera = view.camera;
    scene->lights = view.lights;
    scene->sheet.reset();
    part.scenes.push_back(std::move(scene));
    part.views.push_back(part.own);
  }
  return part;
}

std::vector<FilmPart> parts_of_sheet(const Plan& plan) {
  const Sheet& sheet = *plan.scene->sheet;
  std::vector<FilmPart> parts;
  for (const SheetView& view : sheet.views) {
    const int number = static_cast<int>(parts.size());
    FilmPart part = part_of_sheet(plan, view);
    part.x = number % sheet.columns * plan.view.width;
    part.y = number / sheet.columns * plan.view.height;
    parts.push_back(std::move(part));
  }
  return parts;
}

// A place of the grid of views, in the picture.
Window place_of(const Plan& plan, int column, int row) {
  const int width = plan.view.width, height = plan.view.height;
  return {column * width, row * height, (column + 1) * width, (row + 1) * height};
}
Window within(const Window& a, const Window& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}
bool is_empty(const Window& window) { return window.width() <= 0 || window.height() <= 0; }
Window moved(const Window& window, int x, int y) {
  return {window.x0 + x, window.y0 + y, window.x1 + x, window.y1 + y};
}

}  // namespace

std::vector<FilmPart> parts_of(const Plan& plan) {
  if (plan.scene->sheet) return parts_of_sheet(plan);
  std::vector<SharedScene> scenes;
  std::vector<ViewGrid> grids;
  for (const KnownScene& scene : plan.exposure.scenes) {
    scenes.push_back(scene.scene);
    grids.push_back(views_of(scene->camera, plan.view.width, plan.view.height));
  }
  std::vector<FilmPart> parts;
  for (std::size_t i = 0; i < plan.views.views.size(); ++i) {
    const GridView& of = plan.views.views[i];
    const Window place = place_of(plan, of.column, of.row), seen = within(place, plan.window);
    if (is_empty(seen)) continue;
    FilmPart part{scenes,
                  {},
                  of.view,
                  moved(seen, -place.x0, -place.y0),
                  seen.x0 - plan.window.x0,
                  seen.y0 - plan.window.y0,
                  of.mix};
    for (const ViewGrid& grid : grids) part.views.push_back(grid.views[i].view);
    parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<Window> empty_places(const Plan& plan) {
  const bool is_sheet = plan.scene->sheet.has_value();
  const int columns = is_sheet ? plan.scene->sheet->columns : plan.views.columns;
  const int rows = is_sheet ? plan.scene->sheet->rows() : plan.views.rows;
  const std::size_t views = is_sheet ? plan.scene->sheet->views.size() : plan.views.views.size();
  std::vector<Window> empty;
  if (plan.is_mixed()) return empty;
  for (int i = static_cast<int>(views); i < columns * rows; ++i) {
    const Window seen = within(place_of(plan, i % columns, i / columns), plan.window);
    if (!is_empty(seen)) empty.push_back(moved(seen, -plan.window.x0, -plan.window.y0));
  }
  return empty;
}

std::vector<Instant> instants_of(const FilmPart& part, const std::vector<World>& worlds,
                                 const Exposure& exposure) {
  std::vector<Instant> instants;
  for (const std::size_t i : exposure.strata) instants.push_back({worlds[i], part.views[i]});
  return instants;
}

std::vector<World> own_worlds_of(const PartTracing& by, const FilmPart& part,
                                 const std::vector<World>& worlds) {
  std::vector<World> own;
  for (std::size_t i = 0; by.plan.scene->sheet && i < worlds.size(); ++i)
    by.workers.alone(
        [&] { own.push_back(compile(*part.scenes[i], worlds[i].of_objects, by.workers)); });
  return own;
}

Vec3f nothing_in(const Plan& plan) {
  if (!gathers_light(plan.options.integrator)) return {};
  const auto& backdrop = plan.scene->backdrop;
  return lift<float>(rgb_of(backdrop ? backdrop->color.value_or(Color{}) : plan.scene->background));
}

void add(Rendered& all, const Rendered& more, int before) {
  all.rays += more.rays;
  all.before += more.before;
  if (before == 0) return void(all.reached = more.reached);
  if (!all.reached || !more.reached) return;
  Reached& reached = *all.reached;
  reached.least = std::min(reached.least, more.reached->least);
  reached.most = std::max(reached.most, more.reached->most);
  reached.mean = (reached.mean * before + more.reached->mean) / (before + 1);
  reached.noise = std::max(reached.noise, more.reached->noise);
}

Glimpse of_several(const Glimpse& of_part, const std::function<FilmTile(const FilmTile&)>& place,
                   const Rendered& before, int number, int count) {
  Rendered all = before;
  all.rays += of_part.rays;
  all.before += of_part.before;
  const auto show = [&of_part, &place, before, number, count](const Develop& develop) {
    const auto moving = [&](const FilmTile& tile) { develop(place(tile)); };
    Rendered shown = before;
    add(shown, {{}, of_part.show(moving)}, number);
    shown.reached->mean *= static_cast<double>(number + 1) / count;
    if (number + 1 < count) shown.reached->least = 0;
    return *shown.reached;
  };
  return {true, all.rays, all.before, show};
}

}  // namespace tia::server
