#include "core/radio/images.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>

#include "core/radio/image_path.h"
#include "core/radio/radio_beam.h"

namespace tia {
namespace {

/// ImageTree: the part of a search's tree of images whose first facets are in a range.
class ImageTree {
 public:
  ImageTree(const RadioWorld& world, const PathSearch& search, std::atomic<std::int64_t>& nodes)
      : world_(world), search_(search), nodes_(nodes) {
    found_.by_receiver.resize(search.to.size());
  }

  void straight() { receive(); }
  void from_first(int facet) { mirror(facet, search_.from, {}); }
  PathsTo take() { return std::move(found_); }
  /// Its nodes, instead of paths.
  void list_nodes(std::vector<ImageNode>& into) { list_ = &into; }

 private:
  void mirror(int i, const Vec3d& source, const RadioBeam& beam) {
    const Facet& facet = world_.facet(i);
    const int side = side_of(world_, facet, source);
    if (side == 0) return;
    const bool goes_on = facets_.size() + 1 < static_cast<std::size_t>(search_.max_reflections);
    const bool is_leaf = !goes_on && list_ == nullptr;  // nobody asks for its beam
    std::vector<Vec3d> seen;
    if (search_.pruned && !facet.endless) {
      if (!is_leaf) seen = clipped(facet.hull, beam, world_.slack());
      if (is_leaf ? !sees(beam, facet.hull, world_.slack()) : seen.empty()) return;
    }
    count();
    facets_.push_back(i);
    images_.push_back(facet.face.mirror(source));
    receive();
    if (!is_leaf) {
      const Vec3d image = images_.back();
      const RadioBeam next =
          search_.pruned ? mirrored_beam(beam, facet, side, image, seen) : RadioBeam{};
      if (list_ != nullptr) list_->push_back({facets_, next});
      for (const int each : goes_on ? reached(next) : std::vector<int>{})
        if (each != i) mirror(each, image, next);
    }
    facets_.pop_back();
    images_.pop_back();
  }

  void count() {
    ++found_.counts.images;
    if (nodes_.fetch_add(1, std::memory_order_relaxed) >= search_.most_images)
      throw too_many_images(search_);
  }

  void receive() {
    for (std::size_t i = 0; i < search_.to.size(); ++i) {
      auto path = mirrored_path(world_, search_.from, search_.to[i], facets_, images_);
      if (!path) continue;
      ++found_.counts.candidates;
      if (is_free(world_, *path, facets_, search_.max_transmissions)) keep(i, std::move(*path));
      else ++found_.counts.blocked;
    }
  }

  void keep(std::size_t receiver, RadioPath path) {
    check_paths(search_, ++kept_);
    found_.by_receiver[receiver].push_back(std::move(path));
  }

  // The facets that a beam may reach, in ascending order.
  std::vector<int> reached(const RadioBeam& beam) const {
    std::vector<int> found(world_.endless().begin(), world_.endless().end());
    const Bvh& bvh = world_.bvh();
    std::vector<std::uint32_t> waiting;
    if (!bvh.nodes.empty()) waiting.push_back(0);
    while (!waiting.empty()) {
      const Bvh::Node& node = bvh.nodes[waiting.back()];
      waiting.pop_back();
      for (unsigned k = 0; k < node.boxes.count; ++k) {
        const Box32 box = node.boxes.box(k);
        const Aabb wide{static_cast<Vec3d>(box.min), static_cast<Vec3d>(box.max)};
        if (beam.misses(wide, world_.slack())) continue;
        const BvhChild child = node.children[k];
        if (!child.is_leaf()) waiting.push_back(child.first());
        for (std::uint32_t n = 0; n < child.count(); ++n)
          found.push_back(static_cast<int>(world_.piece(bvh.order[child.first() + n]).facet));
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  const RadioWorld& world_;
  const PathSearch& search_;
  std::atomic<std::int64_t>& nodes_;
  std::vector<int> facets_;
  std::vector<Vec3d> images_;
  PathsTo found_;
  std::size_t kept_ = 0;
  std::vector<ImageNode>* list_ = nullptr;
};

// The parts of a tree: what comes straight, and shares of the first facets.
constexpr std::size_t first_facets = 16;  // of a share
std::size_t shares_of(const RadioWorld& world, const PathSearch& search) {
  const std::size_t firsts = search.max_reflections > 0 ? world.facets().size() : 0;
  return 1 + (firsts + first_facets - 1) / first_facets;
}
void grow(ImageTree& tree, std::size_t share, const RadioWorld& world, const Workers& workers) {
  if (share == 0) return tree.straight();
  const std::size_t first = (share - 1) * first_facets;
  for (std::size_t i = first; i < std::min(first + first_facets, world.facets().size()); ++i) {
    workers.end_if_asked();
    tree.from_first(static_cast<int>(i));
  }
}

bool same_points(const RadioPath& a, const RadioPath& b, double slack) {
  if (a.interactions.size() != b.interactions.size()) return false;
  for (std::size_t i = 0; i < a.interactions.size(); ++i)
    if (!(length(a.interactions[i].point - b.interactions[i].point) <= slack)) return false;
  return true;
}

}  // namespace

InputError too_many_images(const PathSearch& search) {
  return InputError({FaultKind::limit, "/max_reflections", Value(search.max_reflections),
                     "at most " + std::to_string(search.most_images) +
                         " images of transmitters (option TIA_MAX_WORK); fewer "
                         "reflections or faces make fewer"});
}

void check_paths(const PathSearch& search, std::size_t count) {
  if (count <= static_cast<std::size_t>(search.most_paths)) return;
  throw InputError({FaultKind::limit, "/max_reflections", Value(search.max_reflections),
                    "at most " + std::to_string(search.most_paths) +
                        " paths; fewer reflections or receivers have fewer"});
}

PathCounts& PathCounts::operator+=(const PathCounts& other) {
  rays += other.rays, images += other.images, candidates += other.candidates;
  blocked += other.blocked, doubles += other.doubles;
  return *this;
}

std::int64_t sort_paths(std::vector<RadioPath>& paths, double slack) {
  std::sort(paths.begin(), paths.end(), comes_before);
  std::vector<RadioPath> kept;
  for (RadioPath& path : paths) {
    bool again = false;
    for (std::size_t i = kept.size(); i-- > 0 && path.length - kept[i].length <= slack && !again;)
      again = same_points(path, kept[i], 10 * slack);
    if (!again) kept.push_back(std::move(path));
  }
  const auto left_out = static_cast<std::int64_t>(paths.size() - kept.size());
  paths = std::move(kept);
  return left_out;
}

PathsTo paths_by_images(const RadioWorld& world, const PathSearch& search, const Workers& workers) {
  std::vector<PathsTo> parts(shares_of(world, search));
  std::atomic<std::int64_t> nodes{0};
  workers.for_each(static_cast<int>(parts.size()), [&](int task) {
    ImageTree tree(world, search, nodes);
    grow(tree, static_cast<std::size_t>(task), world, workers);
    parts[static_cast<std::size_t>(task)] = tree.take();
  });
  PathsTo all;
  all.by_receiver.resize(search.to.size());
  for (PathsTo& part : parts) {
    all.counts += part.counts;
    for (std::size_t i = 0; i < search.to.size(); ++i)
      std::move(part.by_receiver[i].begin(), part.by_receiver[i].end(),
                std::back_inserter(all.by_receiver[i]));
  }
  for (auto& paths : all.by_receiver) all.counts.doubles += sort_paths(paths, world.slack());
  return all;
}

std::vector<ImageNode> image_nodes(const RadioWorld& world, const PathSearch& search,
                                   const Workers& workers, PathCounts& counts) {
  std::vector<std::vector<ImageNode>> parts(shares_of(world, search));
  std::atomic<std::int64_t> nodes{0};
  workers.for_each(static_cast<int>(parts.size()), [&](int task) {
    ImageTree tree(world, search, nodes);
    std::vector<ImageNode>& part = parts[static_cast<std::size_t>(task)];
    tree.list_nodes(part);
    if (task == 0) part.push_back({});
    grow(tree, static_cast<std::size_t>(task), world, workers);
  });
  std::vector<ImageNode> all;
  for (std::vector<ImageNode>& part : parts)
    std::move(part.begin(), part.end(), std::back_inserter(all));
  counts.images += static_cast<std::int64_t>(all.size()) - 1;
  return all;
}

std::optional<ImageNode> image_node(const RadioWorld& world, const Vec3d& from,
                                    const std::vector<int>& facets, double slack) {
  ImageNode node{facets, {}};
  Vec3d source = from;
  for (const int i : facets) {
    const Facet& facet = world.facet(i);
    const int side = side_of(world, facet, source);
    if (side == 0) return std::nullopt;
    std::vector<Vec3d> seen;
    if (!facet.endless && (seen = clipped(facet.hull, node.beam, slack)).empty())
      return std::nullopt;
    source = facet.face.mirror(source);
    node.beam = mirrored_beam(node.beam, facet, side, source, seen);
  }
  return node;
}

}  // namespace tia
