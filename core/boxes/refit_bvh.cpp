#include "core/boxes/refit_bvh.h"

namespace tia {
namespace {

Box32 around(const Box32& a, const Box32& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
}

constexpr Box32 nothing{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};

void put(BoxSet& boxes, std::size_t slot, const Box32& box) {
  const float all[] = {box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z};
  for (std::size_t i = 0; i < 6; ++i) boxes.faces[i * BoxSet::size + slot] = all[i];
}

}  // namespace

void refit_bvh(Bvh& bvh, const std::vector<bool>& has_moved,
               const std::function<Box32(std::uint32_t)>& box_of) {
  std::vector<bool> is_changed(bvh.nodes.size());
  const auto refit_leaf = [&](Bvh::Node& node, std::size_t slot) {
    const BvhChild leaf = node.children[slot];
    bool moved = false;
    for (std::uint32_t i = 0; i < leaf.count(); ++i)
      moved = moved || has_moved[bvh.order[leaf.first() + i]];
    if (!moved) return false;
    Box32 box = nothing;
    for (std::uint32_t i = 0; i < leaf.count(); ++i)
      box = around(box, box_of(bvh.order[leaf.first() + i]));
    put(node.boxes, slot, box);
    return true;
  };
  const auto refit_inner = [&](Bvh::Node& node, std::size_t slot) {
    const std::uint32_t below = node.children[slot].first();
    if (!is_changed[below]) return false;
    Box32 box = nothing;
    for (std::size_t i = 0; i < bvh.nodes[below].boxes.count; ++i)
      box = around(box, bvh.nodes[below].boxes.box(i));
    put(node.boxes, slot, box);
    return true;
  };
  for (std::size_t i = bvh.nodes.size(); i-- > 0;) {
    Bvh::Node& node = bvh.nodes[i];
    for (std::size_t slot = 0; slot < node.boxes.count; ++slot)
      if (node.children[slot].is_leaf() ? refit_leaf(node, slot) : refit_inner(node, slot))
        is_changed[i] = true;
  }
}

}  // namespace tia
