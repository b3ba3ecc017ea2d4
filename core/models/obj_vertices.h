// What makes equal corners of a part one vertex.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "core/models/obj_content.h"

namespace tia {

/// ObjVertices: numbers the different corners of a part in the order in which they come. Those of a
/// position are a short list, whose first one the position knows; should there be many, the rest
/// are in a tree, so that no file, however contrived, makes it slow. Nothing has to be cleared for
/// the next part.
class ObjVertices {
 public:
  /// Domain: corners with positions below that number.
  explicit ObjVertices(std::size_t positions) : last_(positions, 0) {}

  void begin_part() {
    before_ += static_cast<std::uint32_t>(links_.size());
    links_.clear();
    rest_.clear();
  }
  void reserve(std::size_t count) { links_.reserve(count); }
  /// Returns: the corner's number. It is the count of those before it where it is new.
  std::uint32_t number(const ObjCorner& corner) {
    std::uint32_t& last = last_[corner.position];
    const std::uint32_t first_tried = last > before_ ? last - before_ : 0;
    unsigned tried = 0;
    for (std::uint32_t at = first_tried; at != 0; at = links_[at - 1].next, ++tried)
      if (links_[at - 1].uv == corner.uv && links_[at - 1].normal == corner.normal) return at - 1;
    const auto number = static_cast<std::uint32_t>(links_.size());
    if (tried >= most_tried) {
      const auto [found, is_new] =
          rest_.try_emplace({corner.position, corner.uv, corner.normal}, number);
      if (is_new) links_.push_back({corner.uv, corner.normal, 0});
      return found->second;
    }
    links_.push_back({corner.uv, corner.normal, first_tried});
    last = before_ + number + 1;
    return number;
  }
  std::size_t count() const { return links_.size(); }

 private:
  static constexpr unsigned most_tried = 16;
  /// Link: a vertex, and the one after it in its position's list: its number and 1, or 0.
  struct Link {
    std::uint32_t uv, normal, next;
  };

  std::vector<std::uint32_t> last_;  // a list's start: numbers of all parts go on, from 1
  std::uint32_t before_ = 0;         // of parts before this one
  std::vector<Link> links_;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> rest_;
};

}  // namespace tia
