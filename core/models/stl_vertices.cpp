#include "core/models/stl_vertices.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace tia {
namespace {

constexpr std::size_t fewest_slots = 256, most_probed = 16;

std::array<float, 3> floats_of(const StlPoint& point) {
  return {static_cast<float>(point[0]), static_cast<float>(point[1]), static_cast<float>(point[2])};
}

}  // namespace

void StlVertices::reserve(std::size_t triangles) {
  part_.indices.reserve(3 * triangles);
  part_.positions.reserve(3 * (triangles / 2 + 2));
  grow(std::bit_ceil(std::max(triangles, fewest_slots)));
}

ModelPart StlVertices::take() {
  number_waiting();
  part_.material = 0;
  slots_.clear();
  crowded_.clear();
  return std::exchange(part_, {});
}

void StlVertices::number_waiting() {
  if (2 * (part_.vertices() + waits_) > slots_.size())
    grow(std::max(2 * slots_.size(), fewest_slots));
  std::array<std::size_t, most_waiting> slots;
  for (std::size_t i = 0; i < waits_; ++i) {
    slots[i] = slot_of(floats_of(waiting_[i]));
    __builtin_prefetch(&slots_[slots[i]]);
  }
  for (std::size_t i = 0; i < waits_; ++i) {
    const StlPoint& point = waiting_[i];
    const auto next = static_cast<std::uint32_t>(part_.vertices());
    const std::uint32_t number = number_of(floats_of(point), slots[i], next);
    part_.indices.push_back(number);
    if (number == next) part_.positions.insert(part_.positions.end(), point.begin(), point.end());
  }
  waits_ = 0;
}

std::size_t StlVertices::slot_of(const Key& key) const {
  // Adding 0 makes 0 of -0.
  const auto bits = [](float x) { return std::uint64_t{std::bit_cast<std::uint32_t>(x + 0.0F)}; };
  std::uint64_t hash = (bits(key[0]) << 32U | bits(key[1])) * 0x9E3779B97F4A7C15U;
  hash = (hash ^ hash >> 32U ^ bits(key[2])) * 0xD6E8FEB86659FD93U;
  return hash >> (64 - std::bit_width(slots_.size() - 1));
}

// The number of the vertex that has a key, which is the next one where none has it yet.
std::uint32_t StlVertices::number_of(const Key& key, std::size_t first_slot, std::uint32_t next) {
  for (std::size_t i = 0; i < most_probed; ++i) {
    Slot& slot = slots_[(first_slot + i) & (slots_.size() - 1)];
    if (slot.number == 0) {
      slot = {key, next + 1};
      return next;
    }
    if (slot.key == key) return slot.number - 1;
  }
  return crowded_.try_emplace(key, next).first->second;
}

void StlVertices::grow(std::size_t slots) {
  const auto old_slots = std::exchange(slots_, HugeVector<Slot>(slots));
  const auto old_crowded = std::exchange(crowded_, {});
  for (const Slot& old : old_slots)
    if (old.number != 0) number_of(old.key, slot_of(old.key), old.number - 1);
  for (const auto& [key, number] : old_crowded) number_of(key, slot_of(key), number);
}

}  // namespace tia
