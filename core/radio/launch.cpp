#include "core/radio/launch.h"

#include <algorithm>
#include <cmath>

#include "core/math/deterministic.h"

namespace tia {
namespace {

constexpr double golden = 0.61803398874989485;  // the golden ratio less 1

bool is_flat(const MirrorSequence& mirrors) {
  return std::all_of(mirrors.begin(), mirrors.end(),
                     [](const RadioMirror& each) { return each.facet >= 0; });
}

// How far apart rays of one sequence are that may lead to different paths.
constexpr double bundle = 0.5;  // radians, about
double apart_of(const MirrorSequence& mirrors) { return is_flat(mirrors) ? 4 : bundle / 4; }

// Adds a ray where there is none like it, or puts it in the place of a worse one.
bool keep(std::vector<LaunchedRay>& kept, LaunchedRay ray, double apart) {
  for (LaunchedRay& each : kept) {
    if (length(each.direction - ray.direction) > apart) continue;
    if (ray.miss < each.miss) each = std::move(ray);
    return false;
  }
  kept.push_back(std::move(ray));
  return true;
}

/// RayTracer: traces rays one after another and takes down which receivers they meet.
class RayTracer {
 public:
  RayTracer(const RadioWorld& world, const PathSearch& search, double angle)
      : world_(world), search_(search), angle_(angle) {
    found_.sequences.emplace();
  }

  void trace(const Vec3d& direction) {
    direction_ = direction;
    path_ = {search_.from, {}, {}, 0};
    mirrors_.clear();
    go_on({search_.from, direction, {}, 0, 0, false}, search_.max_transmissions);
  }
  Launched take() { return std::move(found_); }

 private:
  struct State {
    Vec3d from, direction;
    RadioMirror on;  // what it starts from
    double travelled;
    int depth;    // surfaces met
    bool inside;  // of a body that it goes through
  };

  void go_on(const State& ray, int walls) {
    const int from_facet = ray.depth > 0 ? ray.on.facet : -1;
    const auto met = ray.depth > 0 && ray.on.facet < 0
                         ? world_.first_from_curved(ray.from, ray.direction)
                         : world_.first(ray.from, ray.direction, from_facet);
    if (!ray.inside) receive(ray, met ? met->distance : Aabb::far);
    if (!met || ray.depth >= deepest) return;
    const RadioBody& body = world_.body(met->body);
    const RadioMirror mirror{met->facet, met->body, met->facet < 0 ? met->element : 0};
    const double slope = dot(met->normal, ray.direction);
    State next{met->point,    ray.direction, mirror, ray.travelled + met->distance,
               ray.depth + 1, false};
    const bool enters = body.sheet || slope < 0;
    if (body.lets_through() && (!enters || walls > 0)) {
      next.inside = !body.sheet && enters;
      go_on(next, enters ? walls - 1 : walls);
    }
    if (!enters || mirrors_.size() >= static_cast<std::size_t>(search_.max_reflections)) return;
    next.direction = ray.direction - met->normal * (2 * slope);
    next.inside = false;
    mirrors_.push_back(mirror);
    note_sequence();
    path_.interactions.push_back({RadioKind::reflection, met->body, met->element, met->point,
                                  met->normal, std::fabs(slope), 0});
    go_on(next, walls);
    mirrors_.pop_back();
    path_.interactions.pop_back();
  }

  void note_sequence() {
    if (!is_flat(mirrors_)) return;
    facets_.clear();
    for (const RadioMirror& each : mirrors_) facets_.push_back(each.facet);
    found_.sequences.insert(facets_);
  }

  void receive(const State& ray, double reach) {
    const bool flat = is_flat(mirrors_);
    const double ball = flat ? angle_ / std::sqrt(3.0) : bundle;
    for (std::size_t i = 0; i < search_.to.size(); ++i) {
      const Vec3d way = search_.to[i] - ray.from;
      const double along = std::clamp(dot(way, ray.direction), 0.0, reach);
      const double size = ray.travelled + along;
      const double aside = length(way - ray.direction * along);
      if (!(aside <= size * ball) || size == 0) continue;
      RadioPath path = path_;
      path.to = search_.to[i];
      path.length = size;
      LaunchedRay met{direction_, aside / size, std::move(path)};
      if (!keep(found_.rays[{i, mirrors_}], std::move(met), apart_of(mirrors_))) ++found_.doubles;
    }
  }

  static constexpr int deepest = 64;
  const RadioWorld& world_;
  const PathSearch& search_;
  const double angle_;
  Vec3d direction_{};
  RadioPath path_;
  MirrorSequence mirrors_;
  std::vector<int> facets_;
  Launched found_;
};

}  // namespace

Vec3d launch_direction(std::int64_t i, std::int64_t n) {
  const double y = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(n);
  const double turns = static_cast<double>(i) * golden;
  const auto [sine, cosine] = sincos_of(2 * pi * (turns - std::floor(turns)));
  const double aside = std::sqrt(1 - y * y);
  return normalize(Vec3d{aside * cosine, y, aside * sine});
}

double launch_angle(std::int64_t n) { return std::sqrt(4 * pi / static_cast<double>(n)); }

Launched launch(const RadioWorld& world, const PathSearch& search, std::int64_t rays,
                const Workers& workers) {
  constexpr std::int64_t tile = 1024;
  const double angle = launch_angle(rays);
  std::vector<Launched> parts(static_cast<std::size_t>((rays + tile - 1) / tile));
  workers.for_each(static_cast<int>(parts.size()), [&](int task) {
    RayTracer tracer(world, search, angle);
    for (std::int64_t i = task * tile; i < std::min((task + 1) * tile, rays); ++i)
      tracer.trace(launch_direction(i, rays));
    parts[static_cast<std::size_t>(task)] = tracer.take();
  });
  Launched all;
  for (Launched& part : parts) {
    all.doubles += part.doubles;
    all.sequences.merge(part.sequences);
    for (auto& [key, found] : part.rays)
      for (LaunchedRay& ray : found)
        if (!keep(all.rays[key], std::move(ray), apart_of(key.second))) ++all.doubles;
  }
  return all;
}

}  // namespace tia
