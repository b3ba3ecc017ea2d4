#include "core/render/explained_ray.h"

#include "core/scene/left_out.h"
#include "core/scene/views.h"

namespace tia {
namespace {

template <class Real>
SeenRay<Real> ray_through(const View& view, int x, int y, const Aim<float>& aim) {
  return seen_ray(view, static_cast<Real>(x), static_cast<Real>(y),
                  Aim<Real>{aim.dx, aim.dy, aim.lens_x, aim.lens_y});
}

std::vector<Note> notes_of(const Scene& scene, const World& world, IntegratorName integrator) {
  std::vector<Note> notes;
  for (const LeftOut& each : left_out_by(integrator, scene))
    notes.push_back({each.pointer, each.about});
  if (scene.backdrop)
    notes.push_back({"/backdrop",
                     "is what the picture shows where the first ray meets no object; the ray tells "
                     "what is behind it"});
  if (scene.shadow_ground)
    notes.push_back({"/shadow_ground", "the shadow that the picture shows there is not told of"});
  if (scene.sheet) notes.push_back({"/sheet", "the ray is of the scene's own camera"});
  if (!scene.sheet && scene.camera.display && views_of(scene.camera, 1, 1).is_mixed())
    notes.push_back(
        {"/camera/display", "the picture mixes several views; the ray is of the first of them"});
  const std::vector<int>& unasked = world.of_objects->unasked.first;
  for (const auto& [number, pointer] : object_pointers(scene, {unasked.begin(), unasked.end()}))
    notes.push_back({pointer, "path meets its light by chance alone, and asks it for none"});
  return notes;
}

}  // namespace

PixelRays::PixelRays(Instants instants, int x, int y, const RenderOptions& options)
    : instants_(instants),
      x_(x),
      y_(y),
      sampler_({.samples = options.samples,
                .threshold = options.threshold,
                .seed = options.seed,
                .is_chance = row_of(options.integrator).is_chance(),
                .in_rounds = options.noise > 0,
                .blur_steps = options.blur_steps}) {}

Aim<float> PixelRays::aim(int sample) const {
  return sampler_.centered() ? Aim<float>{} : sampler_.aim(x_, y_, sample);
}

Ray<float> PixelRays::traced(int sample) const {
  const auto& [world, view] = at(sample);
  return ray_through<float>(view.seen_from(world.origin), x_, y_, aim(sample)).ray;
}
Ray<double> PixelRays::exact(int sample) const {
  return ray_through<double>(at(sample).view, x_, y_, aim(sample)).ray;
}

void PixelRays::check(int first, int end) const {
  for (int sample = first; sample < end; ++sample)
    if (!ray_through<double>(at(sample).view, x_, y_, aim(sample)).seen)
      throw InputError({FaultKind::out_of_range, "/x", Value(x_),
                        "a pixel inside of the fisheye's disc: outside there is no ray"});
}

ExplainedPixel PixelRays::pixel(int sample) const {
  const Aim<float> to = aim(sample);
  const View& view = at(sample).view;
  const Vec2d raster{x_ + 0.5 + to.dx, y_ + 0.5 + to.dy};
  const Vec2d ndc{raster.u / view.width, raster.v / view.height};
  return {x_, y_, sample, raster, ndc, {2 * ndc.u - 1, 1 - 2 * ndc.v}};
}

SamplerState<float> PixelRays::state(int sample) const {
  return {{static_cast<std::uint32_t>(x_)},
          {static_cast<std::uint32_t>(y_)},
          static_cast<std::uint32_t>(sampler_.point(sample)),
          sampler_.key()};
}

Ray<float> traced_in(const World& world, const Ray<double>& ray) {
  return {lift<float>(ray.origin - world.origin), normalize(lift<float>(ray.direction))};
}

WorldView world_view_of(const World& world, const View* view, const RenderOptions& options,
                        RayMeter& meter) {
  return {world,
          WorkCounter([&meter](std::int64_t work) { meter.add_work(work); }),
          rules_of(options),
          {},
          0,
          view != nullptr ? cone_of(*view) : PixelCone{},
          view};
}

void tell_hits(Explanation& all, ExplanationSize& size) {
  const Vec3d& origin = all.world.origin;
  all.hits = all_hits(all.world, {all.ray.origin - origin, all.ray.direction});
  for (Meeting& each : all.hits) {
    each.point = each.point + origin;
    size.hit(each);
  }
}

void tell_rest(Explanation& all, const Scene& scene, IntegratorName integrator,
               ExplanationSize& size) {
  all.notes = notes_of(scene, all.world, integrator);
  for (const Note& each : all.notes) size.note(each.pointer, each.about);
  all.pointers = object_pointers(scene, size.objects());
  all.most_bytes = size.bytes();
}

Value triple_value(const Vec3f& v) { return Value::Array{v.x, v.y, v.z}; }

void add_copy(const World& world, Value::Object& to, const char* name, int primitive,
              std::int64_t copy) {
  const Geometry& geometry = world.geometry_of(primitive);
  Value::Array groups;
  for (const auto& [i, j, k] :
       instances_around(geometry, geometry.primitive(primitive).space, copy))
    groups.push_back(Value::Array{i, j, k});
  if (!groups.empty()) to.emplace_back(name, std::move(groups));
}

}  // namespace tia
