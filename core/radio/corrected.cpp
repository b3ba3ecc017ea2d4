// paths_by_rays: what was launched as paths, each checked, and corrected where that is asked for.
#include <algorithm>
#include <cmath>

#include "core/radio/curved_path.h"
#include "core/radio/image_path.h"
#include "core/radio/launch.h"

namespace tia {
namespace {

/// PathCollector: checks paths, and keeps those that are free.
class PathCollector {
 public:
  PathCollector(const RadioWorld& world, const PathSearch& search)
      : world_(world), search_(search) {
    all_.by_receiver.resize(search.to.size());
  }

  void add(std::size_t receiver, std::optional<RadioPath> path, const std::vector<int>& facets) {
    if (!path) return;
    ++all_.counts.candidates;
    if (is_free(world_, *path, facets, search_.max_transmissions)) keep(receiver, std::move(*path));
    else ++all_.counts.blocked;
  }
  PathsTo take(double same) {
    for (auto& paths : all_.by_receiver) all_.counts.doubles += sort_paths(paths, same);
    return std::move(all_);
  }
  PathCounts& counts() { return all_.counts; }

 private:
  void keep(std::size_t receiver, RadioPath path) {
    check_paths(search_, ++kept_);
    all_.by_receiver[receiver].push_back(std::move(path));
  }

  const RadioWorld& world_;
  const PathSearch& search_;
  PathsTo all_;
  std::size_t kept_ = 0;
};

std::vector<int> facets_of(const MirrorSequence& mirrors) {
  std::vector<int> facets;
  for (const RadioMirror& each : mirrors) facets.push_back(each.facet);
  return facets;
}
bool any_curved(const std::vector<int>& facets) {
  return std::find(facets.begin(), facets.end(), -1) != facets.end();
}

// As they were traced, those within their balls.
void add_raw(Launched& launched, double ball, PathCollector& out) {
  for (auto& [key, found] : launched.rays)
    for (LaunchedRay& ray : found)
      if (ray.miss <= ball) out.add(key.first, std::move(ray.path), facets_of(key.second));
}

// The flat sequences, each for all receivers; shares of them are tried side by side.
void add_mirrored(const RadioWorld& world, const PathSearch& search, const Launched& launched,
                  const Workers& workers, PathCollector& out) {
  const std::vector<std::vector<int>> sequences(launched.sequences.begin(),
                                                launched.sequences.end());
  using Found = std::pair<std::size_t, RadioPath>;
  constexpr std::size_t share = 256;
  const std::size_t tasks = (sequences.size() + share - 1) / share;
  std::vector<std::vector<std::pair<std::size_t, Found>>> parts(tasks);
  workers.for_each(static_cast<int>(tasks), [&](int task) {
    const std::size_t first = static_cast<std::size_t>(task) * share;
    for (std::size_t i = first; i < std::min(first + share, sequences.size()); ++i) {
      const std::vector<Vec3d> images = images_of(world, search.from, sequences[i]);
      for (std::size_t r = 0; r < search.to.size(); ++r)
        if (auto path = mirrored_path(world, search.from, search.to[r], sequences[i], images))
          parts[static_cast<std::size_t>(task)].push_back({i, {r, std::move(*path)}});
    }
  });
  for (auto& part : parts)
    for (auto& [i, found] : part) out.add(found.first, std::move(found.second), sequences[i]);
}

void add_aimed(const RadioWorld& world, const Launched& launched, const Workers& workers,
               PathCollector& out) {
  for (const auto& [key, found] : launched.rays) {
    const std::vector<int> facets = facets_of(key.second);
    if (!any_curved(facets)) continue;
    for (const LaunchedRay& ray : found) {
      workers.end_if_asked();
      out.add(key.first, curved_path(world, ray.path, ray.direction, key.second), facets);
    }
  }
}

}  // namespace

PathsTo paths_by_rays(const RadioWorld& world, const PathSearch& search, std::int64_t rays,
                      bool corrected, const Workers& workers) {
  Launched launched = launch(world, search, rays, workers);
  PathCollector out(world, search);
  out.counts().rays = rays;
  out.counts().doubles = launched.doubles;
  if (!corrected) {
    add_raw(launched, launch_angle(rays) / std::sqrt(3.0), out);
    return out.take(0);
  }
  const auto images = static_cast<std::int64_t>(launched.sequences.size()) *
                      static_cast<std::int64_t>(search.to.size());
  if (images > search.most_images) throw too_many_images(search);
  out.counts().images = images;
  add_mirrored(world, search, launched, workers, out);
  add_aimed(world, launched, workers, out);
  return out.take(world.curved().empty() ? world.slack() : 1e3 * world.slack());
}

}  // namespace tia
