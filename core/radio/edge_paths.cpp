#include "core/radio/edge_paths.h"

#include <algorithm>
#include <iterator>

#include "core/radio/diffraction.h"
#include "core/radio/image_path.h"

namespace tia {

void add_edge_paths(const RadioWorld& world, const PathSearch& search, const Workers& workers,
                    PathsTo& out) {
  const std::vector<RadioEdge>& edges = world.all().edges;
  std::vector<std::vector<RadioPath>> found(search.to.size());
  std::vector<PathCounts> counts(search.to.size());
  workers.for_each(static_cast<int>(search.to.size()), [&](int task) {
    const auto r = static_cast<std::size_t>(task);
    constexpr int no_facet = -1;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      auto path = edge_path(edges[i], static_cast<int>(i), search.from, search.to[r]);
      if (!path) continue;
      ++counts[r].candidates;
      if (!is_free(world, *path, {&no_facet, 1}, search.max_transmissions)) ++counts[r].blocked;
      else found[r].push_back(std::move(*path));
    }
  });
  std::size_t count = 0;
  for (std::size_t r = 0; r < found.size(); ++r) {
    std::vector<RadioPath>& paths = out.by_receiver[r];
    paths.insert(paths.end(), std::make_move_iterator(found[r].begin()),
                 std::make_move_iterator(found[r].end()));
    std::sort(paths.begin(), paths.end(), comes_before);
    out.counts += counts[r];
    check_paths(search, count += paths.size());
  }
}

}  // namespace tia
