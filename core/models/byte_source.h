// ByteSource: bytes that come one after the other, from memory or from another process.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

#include "core/models/model.h"
#include "core/models/model_files.h"

namespace tia {

class ByteSource {
 public:
  ByteSource() = default;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;
  virtual ~ByteSource() = default;

  /// Takes what comes next. Returns: how many bytes, at least one; 0 at the end.
  /// Domain: there is room.
  virtual std::size_t read(std::span<std::uint8_t> room) = 0;
  /// How many may still come at most.
  virtual std::uint64_t most() const = 0;

  /// Takes as many as there is room for. Returns: whether there were so many.
  bool fill(std::span<std::uint8_t> room) {
    while (!room.empty()) {
      const std::size_t got = read(room);
      if (got == 0) return false;
      room = room.subspan(got);
    }
    return true;
  }
};

/// BytesInMemory: those that are there already, somewhere else.
class BytesInMemory : public ByteSource {
 public:
  explicit BytesInMemory(ModelBytes bytes) : left_(bytes) {}
  std::size_t read(std::span<std::uint8_t> room) override {
    const ModelBytes next = left_.first(std::min(room.size(), left_.size()));
    std::copy(next.begin(), next.end(), room.begin());
    left_ = left_.subspan(next.size());
    return next.size();
  }
  std::uint64_t most() const override { return left_.size(); }

 private:
  ModelBytes left_;
};

/// Takes so many numbers or letters behind those of a list. Memory is taken in pieces, as they
/// come, and is still in the processor's cache when they are written over its zeros.
/// Returns: whether there were so many. Domain: they are at most `source.most()` bytes.
template <class List>
bool take_list(ByteSource& source, std::uint64_t size, List& list) {
  constexpr std::uint64_t number = sizeof(list[0]), piece = (std::uint64_t{1} << 18U) / number;
  const std::uint64_t whole = list.size() + size;
  list.reserve(whole);
  while (list.size() < whole) {
    const std::size_t before = list.size();
    list.resize(std::min(whole, before + piece));
    auto* const room = reinterpret_cast<std::uint8_t*>(list.data() + before);
    if (!source.fill({room, (list.size() - before) * number})) return false;
  }
  return true;
}

/// As unarchived() of bytes that are there (archive.h): of the next `length` that come. It takes no
/// memory before they do, but addresses for the list that they say comes next.
std::optional<Model> unarchived(ByteSource& source, std::uint64_t length);

}  // namespace tia
