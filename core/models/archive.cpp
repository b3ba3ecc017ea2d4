#include "core/models/archive.h"

#include <cstring>
#include <type_traits>

namespace tia {
namespace {

template <class T>
concept IsArchivedRaw = std::is_arithmetic_v<T> || std::is_enum_v<T>;
template <class T>
concept HasMembers = requires {
  T::members;
};

/// ArchiveWriter: to the end of `bytes`; null: only counts.
class ArchiveWriter {
 public:
  explicit ArchiveWriter(std::vector<std::uint8_t>* bytes) : bytes_(bytes) {}
  std::size_t size() const { return size_; }

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
    size_ += size;
    if (bytes_ == nullptr) return;
    const auto* first = static_cast<const std::uint8_t*>(from);
    bytes_->insert(bytes_->end(), first, first + size);
  }

  std::vector<std::uint8_t>* const bytes_;
  std::size_t size_ = 0;
};

class ArchiveReader {
 public:
  explicit ArchiveReader(ModelBytes bytes) : left_(bytes) {}
  /// Whether all was there, and nothing is left.
  bool done() const { return good_ && left_.empty(); }

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
    good_ = good_ && size <= left_.size() / sizeof(list[0]);
    if (!good_) return;
    list.resize(size);
    get_raw(list.data(), size * sizeof(list[0]));
  }
  void get_raw(void* to, std::size_t size) {
    good_ = good_ && size <= left_.size();
    if (!good_ || size == 0) return;
    std::memcpy(to, left_.data(), size);
    left_ = left_.subspan(size);
  }

  ModelBytes left_;
  bool good_ = true;
};

}  // namespace

void append_archive(const Model& model, std::vector<std::uint8_t>& bytes) {
  ArchiveWriter counting(nullptr), writing(&bytes);
  counting.put(model);
  bytes.reserve(bytes.size() + counting.size());  // it may be half of what the reader takes
  writing.put(model);
}

std::optional<Model> unarchived(ModelBytes bytes) {
  ArchiveReader reader(bytes);
  std::optional<Model> model(std::in_place);
  reader.get(*model);
  if (!reader.done()) model.reset();
  return model;
}

}  // namespace tia
