// How far a formula's surface is parted into boxes before any ray is traced (formula/field_cells.h,
// parametric/patches.h).
#pragma once

namespace tia::detail {

// What the making of a tree may take: the cost of all evaluations, each of eight pieces at once,
// and levels, each of which halves three times.
inline constexpr double most_tree_cost = 4e6;
inline constexpr int most_tree_levels = 10;
// A piece is flat enough, and parted no more, where its slopes differ from the middle ones by no
// more than this part of them.
inline constexpr double flat_enough = 0.2;

}  // namespace tia::detail
