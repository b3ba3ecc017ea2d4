#include "server/requests/parts.h"

#include <algorithm>

namespace tia::server {

Window whole_window(const PictureRequest& asked, const Scene& scene) {
  Window window = asked.window();
  if (!scene.sheet) return window;
  window.x1 = asked.width * scene.sheet->columns;
  window.y1 = asked.height * scene.sheet->rows();
  return window;
}

namespace {

Part whole_part(const Plan& plan) {
  Part part{{}, {}, plan.window};
  for (const KnownScene& scene : plan.exposure.scenes) {
    part.scenes.push_back(scene.scene);
    part.views.push_back(view_of(scene->camera, plan.view.width, plan.view.height));
  }
  return part;
}

Part part_of(const Plan& plan, const SheetView& view) {
  const int width = plan.view.width, height = plan.view.height;
  Part part{{}, {}, {0, 0, width, height}};
  for (const KnownScene& each : plan.exposure.scenes) {
    auto scene = std::make_shared<Scene>(*each);
    scene->camera = view.camera;
    scene->lights = view.lights;
    scene->sheet.reset();
    part.scenes.push_back(std::move(scene));
    part.views.push_back(view_of(view.camera, width, height));
  }
  return part;
}

}  // namespace

std::vector<Part> parts_of(const Plan& plan) {
  if (!plan.scene->sheet) return {whole_part(plan)};
  const Sheet& sheet = *plan.scene->sheet;
  std::vector<Part> parts;
  for (const SheetView& view : sheet.views) {
    const int number = static_cast<int>(parts.size());
    Part part = part_of(plan, view);
    part.x = number % sheet.columns * plan.view.width;
    part.y = number / sheet.columns * plan.view.height;
    parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<Instant> instants_of(const Part& part, const std::vector<World>& worlds,
                                 const Exposure& exposure) {
  std::vector<Instant> instants;
  for (const std::size_t i : exposure.strata) instants.push_back({worlds[i], part.views[i]});
  return instants;
}

Vec3f nothing_in(const Plan& plan) {
  if (!gathers_light(plan.options.integrator)) return {};
  const auto& backdrop = plan.scene->backdrop;
  return lift<float>(rgb_of(backdrop ? backdrop->color.value_or(Color{}) : plan.scene->background));
}

void add(Rendered& all, const Rendered& more, int before) {
  all.rays += more.rays;
  all.before += more.before;
  if (!all.reached || !more.reached) return void(all.reached = more.reached);
  Reached& reached = *all.reached;
  reached.least = std::min(reached.least, more.reached->least);
  reached.most = std::max(reached.most, more.reached->most);
  reached.mean = (reached.mean * before + more.reached->mean) / (before + 1);
  reached.noise = std::max(reached.noise, more.reached->noise);
}

Glimpse of_sheet(const Glimpse& of_part, const Part& part, const Rendered& before, int number,
                 const Sheet& sheet) {
  Rendered all = before;
  all.rays += of_part.rays;
  all.before += of_part.before;
  const auto show = [&of_part, &part, before, number, &sheet](const Develop& develop) {
    const auto moving = [&](const FilmTile& tile) { develop(moved(tile, part)); };
    Rendered shown = before;
    add(shown, {{}, of_part.show(moving)}, number);
    const auto views = static_cast<int>(sheet.views.size());
    shown.reached->mean *= static_cast<double>(number + 1) / views;
    if (number + 1 < views) shown.reached->least = 0;
    return *shown.reached;
  };
  return {true, all.rays, all.before, show};
}

}  // namespace tia::server
