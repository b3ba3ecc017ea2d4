// The vertices of triangles that come corner by corner.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "core/boxes/huge_pages.h"
#include "core/models/model.h"

namespace tia {

/// StlPoint: where a corner lies: x, y, z.
using StlPoint = std::array<double, 3>;

/// StlVertices: corners of which those that are equal as floats (-0 and 0 are) are one vertex,
/// which lies where the first of them lies; vertices are numbered in the order in which they come.
/// Domain: fewer than 2^32 corners, each within most_coordinate.
/// Cost: n log n whatever the corners are, n where they are not chosen to cost time. Memory: 4
/// bytes a corner and at most 120 a vertex, of which 24 remain; of chosen corners 80 more.
class StlVertices {
 public:
  /// Makes room for what so many triangles make if they are a closed surface.
  void reserve(std::size_t triangles);
  /// The next corner.
  void add(const StlPoint& point) {
    waiting_[waits_++] = point;
    if (waits_ == waiting_.size()) number_waiting();
  }
  bool empty() const { return waits_ == 0 && part_.indices.empty(); }
  /// The triangles, which are taken out.
  ModelPart take();

 private:
  using Key = std::array<float, 3>;
  struct Slot {
    Key key;
    std::uint32_t number;  // of a vertex, from 1; 0: empty
  };
  void number_waiting();
  std::size_t slot_of(const Key& key) const;
  std::uint32_t number_of(const Key& key, std::size_t first_slot, std::uint32_t next);
  void grow(std::size_t slots);

  // Corners wait for each other, so that memory is asked for all of their slots at once.
  static constexpr std::size_t most_waiting = 32;
  std::array<StlPoint, most_waiting> waiting_;
  std::size_t waits_ = 0;
  ModelPart part_;
  // A vertex stands in one of a few slots from its hash on. What finds them taken stands in a tree:
  // hashes can be chosen to be equal, and then a longer search among slots would be quadratic.
  HugeVector<Slot> slots_;
  std::map<Key, std::uint32_t> crowded_;
};

}  // namespace tia
