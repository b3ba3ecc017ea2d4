// PackedLeaves: the numbers of the things in a tree's leaves as a structure of arrays: for each
// leaf the first word of all its things, then the second, so that a register loads a word of
// several things.
#pragma once

#include <cstdint>
#include <vector>

#include "core/boxes/bvh.h"
#include "core/parallel/workers.h"

namespace tia {

/// PackedLeaves: `words` numbers for each thing of a Bvh, in its order. A leaf begins at `words`
/// times its first entry, and is followed by at least a register's numbers that may be loaded.
template <class Number, std::size_t words>
class PackedLeaves {
 public:
  PackedLeaves() = default;
  /// words_of(thing) gives an array of them.
  template <class WordsOf>
  PackedLeaves(const Bvh& bvh, const Workers& workers, WordsOf words_of)
      : numbers_(words * bvh.order.size() + slack) {
    workers.for_each_share(bvh.nodes.size(), [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) pack(bvh, bvh.nodes[i], words_of);
    });
  }
  /// Of the leaf that begins at that entry.
  const Number* leaf(std::size_t first) const { return &numbers_[words * first]; }
  std::size_t bytes() const { return heap_bytes(numbers_); }

 private:
  static constexpr std::size_t slack = 16;

  template <class WordsOf>
  void pack(const Bvh& bvh, const Bvh::Node& node, WordsOf words_of) {
    for (std::size_t child = 0; child < node.boxes.count; ++child) {
      const std::size_t first = node.children[child].first(), count = node.children[child].count();
      for (std::size_t i = 0; i < count; ++i) {
        const std::array<Number, words> all = words_of(bvh.order[first + i]);
        for (std::size_t k = 0; k < words; ++k) numbers_[words * first + k * count + i] = all[k];
      }
    }
  }

  HugeVector<Number> numbers_;
};

}  // namespace tia
