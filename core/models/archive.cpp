#include "core/models/archive.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include "core/models/byte_source.h"

namespace tia {
namespace {

template <class T>
concept IsArchivedRaw = std::is_arithmetic_v<T> || std::is_enum_v<T>;
template <class T>
concept HasMembers = requires {
  T::members;
};

/// ArchiveWriter: gives all that is put to `Sink`, as bytes.
template <class Sink>
class ArchiveWriter {
 public:
  explicit ArchiveWriter(Sink& sink) : sink_(sink) {}

  template <IsArchivedRaw T>
  void put(const T& value) {
    put_raw(&value, sizeof value);
  }
  void put(const std::string& text) { put_list(text); }
  void put(const Color& c) { put(std::array{c.r, c.g, c.b}); }
  void put(const Vec3d& v) { put(std::array{v.x, v.y, v.z}); }
  template <class T>
  void put(const std::optional<T>& maybe) {
    put(maybe.has_value());
    if (maybe) put(*maybe);
  }
  template <class T, std::size_t n>
  void put(const std::array<T, n>& values) {
    for (const T& each : values) put(each);
  }
  template <class T>
  void put(const std::vector<T>& list) {
    if constexpr (IsArchivedRaw<T>) return put_list(list);
    put(std::uint64_t{list.size()});
    for (const T& each : list) put(each);
  }
  template <HasMembers T>
  void put(const T& value) {
    std::apply([&](auto... member) { (put(value.*member), ...); }, T::members);
  }

 private:
  template <class List>
  void put_list(const List& list) {
    put(std::uint64_t{list.size()});
    put_raw(list.data(), list.size() * sizeof(list[0]));
  }
  void put_raw(const void* from, std::size_t size) {
    sink_({static_cast<const std::uint8_t*>(from), size});
  }

  Sink& sink_;
};

/// ArchiveGathering: puts short pieces together, and passes on long ones as they are.
class ArchiveGathering {
 public:
  explicit ArchiveGathering(const std::function<void(ModelBytes)>& write) : write_(write) {}
  void operator()(ModelBytes piece) {
    if (piece.size() > gathered_.size() - used_) flush();
    if (piece.size() > gathered_.size()) return write_(piece);
    std::copy(piece.begin(), piece.end(), gathered_.data() + used_);
    used_ += piece.size();
  }
  void flush() {
    if (used_ > 0) write_({gathered_.data(), std::exchange(used_, 0)});
  }

 private:
  const std::function<void(ModelBytes)>& write_;
  std::array<std::uint8_t, 4096> gathered_;
  std::size_t used_ = 0;
};

class ArchiveReader {
 public:
  ArchiveReader(ByteSource& source, std::uint64_t length)
      : source_(source), left_(length), good_(length <= source.most()) {}
  /// Whether all was there, and nothing is left.
  bool done() const { return good_ && left_ == 0; }

  void get(bool& value) {
    std::uint8_t byte = 0;
    get(byte);
    value = byte == 1;
    good_ = good_ && byte <= 1;
  }
  template <IsArchivedRaw T>
  void get(T& value) {
    get_raw(&value, sizeof value);
  }
  void get(std::string& text) { get_list(text); }
  void get(Color& c) {
    for (double* each : {&c.r, &c.g, &c.b}) get(*each);
  }
  void get(Vec3d& v) {
    for (double* each : {&v.x, &v.y, &v.z}) get(*each);
  }
  template <class T>
  void get(std::optional<T>& maybe) {
    bool there = false;
    get(there);
    if (there && good_) get(maybe.emplace());
  }
  template <class T, std::size_t n>
  void get(std::array<T, n>& values) {
    for (T& each : values) get(each);
  }
  template <class T>
  void get(std::vector<T>& list) {
    if constexpr (IsArchivedRaw<T>) return get_list(list);
    std::uint64_t size = 0;
    get(size);
    // Not reserved: each takes some bytes, and nobody knows yet whether they are there.
    for (std::uint64_t i = 0; i < size && good_; ++i) get(list.emplace_back());
  }
  template <HasMembers T>
  void get(T& value) {
    std::apply([&](auto... member) { (get(value.*member), ...); }, T::members);
  }

 private:
  template <class List>
  void get_list(List& list) {
    std::uint64_t size = 0;
    get(size);
    good_ = good_ && size <= left_ / sizeof(list[0]);
    if (!good_) return;
    left_ -= size * sizeof(list[0]);
    good_ = take_list(source_, size, list);
  }
  void get_raw(void* to, std::size_t size) {
    good_ = good_ && size <= left_;
    if (!good_) return;
    left_ -= size;
    good_ = source_.fill({static_cast<std::uint8_t*>(to), size});
  }

  ByteSource& source_;
  std::uint64_t left_;
  bool good_;
};

}  // namespace

std::uint64_t archive_size(const Model& model) {
  std::uint64_t size = 0;
  const auto count = [&](ModelBytes piece) { size += piece.size(); };
  ArchiveWriter(count).put(model);
  return size;
}

void write_archive(const Model& model, const std::function<void(ModelBytes)>& write) {
  ArchiveGathering gathering(write);
  ArchiveWriter(gathering).put(model);
  gathering.flush();
}

std::optional<Model> unarchived(ByteSource& source, std::uint64_t length) {
  ArchiveReader reader(source, length);
  std::optional<Model> model(std::in_place);
  reader.get(*model);
  if (!reader.done()) model.reset();
  return model;
}

std::optional<Model> unarchived(ModelBytes bytes) {
  BytesInMemory source(bytes);
  return unarchived(source, bytes.size());
}

}  // namespace tia
