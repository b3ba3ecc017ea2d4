#include "core/radio/seen_cells.h"

#include <algorithm>
#include <iterator>

#include "core/radio/diffraction.h"
#include "core/radio/edge_paths.h"
#include "core/radio/image_path.h"
#include "core/radio/launch.h"

namespace tia {
namespace {

// Paths may pass beside a face by the world's slack; where the image is near to it, that is much
// more at the receiver.
constexpr double widening = 1e5;

std::vector<ImageNode> nodes_of_rays(const RadioWorld& world, const PathSearch& search,
                                     std::int64_t rays, double slack, const Workers& workers,
                                     PathCounts& counts) {
  PathSearch nobody = search;
  nobody.to.clear();
  const Launched launched = launch(world, nobody, rays, workers);
  counts.rays += rays;
  std::vector<ImageNode> nodes;
  for (const std::vector<int>& facets : launched.sequences)
    if (auto node = image_node(world, search.from, facets, slack))
      nodes.push_back(std::move(*node));
  counts.images += static_cast<std::int64_t>(nodes.size());
  if (counts.images > search.most_images) throw too_many_images(search);
  return nodes;
}

}  // namespace

MirrorSequences::MirrorSequences(const RadioWorld& world, const PathSearch& search,
                                 const RadioQuestion& question, const Workers& workers)
    : world_(world), search_(search), margin_(widening * world.slack()) {
  search_.to.clear();
  nodes_ = question.method == RadioMethod::image
               ? image_nodes(world, search_, workers, counts_)
               : nodes_of_rays(world, search_, question.rays, margin_, workers, counts_);
}

std::vector<std::vector<RadioPath>> MirrorSequences::paths_to(std::span<const Vec3d> receivers,
                                                              std::atomic<std::int64_t>& images,
                                                              std::int64_t most_images) const {
  Aabb around_all;
  for (const Vec3d& each : receivers) around_all = around(around_all, each);
  std::vector<std::vector<RadioPath>> found(receivers.size());
  for (const ImageNode& node : nodes_) {
    if (node.beam.misses(around_all, margin_)) continue;
    const std::vector<Vec3d> mirrored = images_of(world_, search_.from, node.facets);
    std::int64_t tried = 0;
    for (std::size_t i = 0; i < receivers.size(); ++i) {
      if (!node.beam.holds(receivers[i], margin_)) continue;
      ++tried;
      auto path = mirrored_path(world_, search_.from, receivers[i], node.facets, mirrored);
      if (path && is_free(world_, *path, node.facets, search_.max_transmissions))
        found[i].push_back(std::move(*path));
    }
    if (images.fetch_add(tried, std::memory_order_relaxed) + tried > most_images)
      throw too_many_images(search_);
  }
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    sort_paths(found[i], world_.slack());
    if (search_.max_diffractions > 0) add_edges(receivers[i], found[i]);
  }
  return found;
}

void MirrorSequences::add_edges(const Vec3d& receiver, std::vector<RadioPath>& paths) const {
  PathSearch search = search_;
  search.to = {receiver};
  PathsTo all;
  all.by_receiver.push_back(std::move(paths));
  add_edge_paths(world_, search, Workers{}, all);
  paths = std::move(all.by_receiver.front());
}

}  // namespace tia
