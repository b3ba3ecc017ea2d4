// ByteBuffer: bytes that come one after the other, and nobody knows how many will.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <utility>

namespace tia::server {

/// ByteBuffer. Beside a vector it writes nothing into room for what is to come, and is given more
/// of it without being copied: the C library moves a long piece by its pages (realloc, mremap).
class ByteBuffer {
 public:
  ByteBuffer() = default;
  ByteBuffer(ByteBuffer&& other) noexcept { swap(other); }
  ByteBuffer& operator=(ByteBuffer&& other) noexcept {
    ByteBuffer(std::move(other)).swap(*this);
    return *this;
  }

  std::size_t size() const { return size_; }
  bool is_full() const { return size_ == capacity_; }
  const std::uint8_t* begin() const { return bytes_.get(); }
  const std::uint8_t* end() const { return bytes_.get() + size_; }

  /// Makes room for that many bytes in all. Errors: std::bad_alloc, and nothing has changed.
  void reserve(std::size_t bytes) {
    if (bytes <= capacity_) return;
    void* const moved = std::realloc(bytes_.get(), bytes);
    if (moved == nullptr) throw std::bad_alloc();
    static_cast<void>(bytes_.release());  // realloc has freed it
    bytes_.reset(static_cast<std::uint8_t*>(moved));
    capacity_ = bytes;
  }
  /// What may be written behind the bytes. Errors: as reserve().
  std::span<std::uint8_t> room(std::size_t least) {
    if (capacity_ - size_ < least) reserve(std::max(size_ + least, 2 * capacity_));
    return {bytes_.get() + size_, capacity_ - size_};
  }
  /// So many bytes of that room are bytes of its own now.
  void add(std::size_t written) { size_ += written; }

 private:
  struct Free {
    void operator()(std::uint8_t* bytes) const { std::free(bytes); }
  };
  void swap(ByteBuffer& other) noexcept {
    bytes_.swap(other.bytes_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  std::unique_ptr<std::uint8_t, Free> bytes_;
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace tia::server
