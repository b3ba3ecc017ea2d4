#include "core/models/gltf/gltf_tree.h"

namespace tia::gltf {
namespace {

constexpr ModelIndex no_node = 0xFFFF'FFFF;

std::vector<ModelIndex> parents_of(const GltfSource& source, const std::vector<ModelNode>& nodes) {
  std::vector<ModelIndex> parents(nodes.size(), no_node);
  const Place list = source.root.at().at("nodes");
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t k = 0; k < nodes[i].children.size() && !source.faults.full(); ++k) {
      const ModelIndex child = nodes[i].children[k];
      if (parents[child] == i) continue;  // twice in one list, which is a fault already
      if (parents[child] == no_node) parents[child] = static_cast<ModelIndex>(i);
      else
        source.faults.add({FaultKind::conflict, list.at(i).at("children").at(k).pointer(),
                           Value(static_cast<double>(child)),
                           "nodes without another parent: this one is a child of node " +
                               std::to_string(parents[child])});
    }
  return parents;
}

// Each way up ends at a root, at a node that has been seen, or where it began: in a circle.
void refuse_circles(const GltfSource& source, const std::vector<ModelIndex>& parents) {
  std::vector<ModelIndex> seen(parents.size(), no_node);  // by the way that began at that node
  std::vector<bool> circle(parents.size());
  for (std::size_t start = 0; start < parents.size(); ++start) {
    ModelIndex node = static_cast<ModelIndex>(start);
    while (node != no_node && seen[node] == no_node) {
      seen[node] = static_cast<ModelIndex>(start);
      node = parents[node];
    }
    if (node == no_node || seen[node] != start) continue;
    for (; !circle[node]; node = parents[node]) circle[node] = true;
  }
  const Place list = source.root.at().at("nodes");
  for (std::size_t i = 0; i < circle.size() && !source.faults.full(); ++i)
    if (circle[i])
      source.faults.add({FaultKind::conflict, list.at(i).pointer(),
                         Value("a node below node " + std::to_string(parents[i])),
                         "nodes that are not below themselves"});
}

// Level by level, from the roots down.
void check_depth(const GltfSource& source, const std::vector<ModelNode>& nodes,
                 const std::vector<ModelIndex>& roots) {
  std::vector<ModelIndex> level = roots, next;
  for (std::uint64_t depth = 1; !level.empty(); ++depth) {
    if (depth > source.limits.depth)
      return source.faults.add(
          {FaultKind::limit, source.root.at().at("nodes").at(level.front()).pointer(), std::nullopt,
           "nodes at most " + std::to_string(source.limits.depth) + " deep in each other"});
    next.clear();
    for (const ModelIndex node : level)
      next.insert(next.end(), nodes[node].children.begin(), nodes[node].children.end());
    std::swap(level, next);
  }
}

}  // namespace

std::vector<ModelIndex> check_tree(const GltfSource& source, const std::vector<ModelNode>& nodes) {
  const std::size_t before = source.faults.count();
  const std::vector<ModelIndex> parents = parents_of(source, nodes);
  refuse_circles(source, parents);
  std::vector<ModelIndex> roots;
  for (std::size_t i = 0; i < parents.size(); ++i)
    if (parents[i] == no_node) roots.push_back(static_cast<ModelIndex>(i));
  // With one parent each, what hangs at a root is met once.
  if (source.faults.count() == before) check_depth(source, nodes, roots);
  return roots;
}

}  // namespace tia::gltf
