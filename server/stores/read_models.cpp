#include "server/stores/read_models.h"

#include <optional>
#include <tuple>
#include <type_traits>
#include <vector>

#include "core/scene/model_maps.h"

namespace tia::server {
namespace {

constexpr std::size_t read_entry_bytes = 640;  // an entry's own, with its places in list and table

template <class T>
constexpr bool is_list = false;
template <class T>
constexpr bool is_list<std::vector<T>> = true;
template <>
constexpr bool is_list<std::string> = true;

// What a part of a model holds beside its own bytes.
template <class T>
std::size_t bytes_beside(const T& part) {
  if constexpr (is_list<T>) {
    std::size_t bytes = part.capacity() * sizeof(typename T::value_type);
    if constexpr (!std::is_arithmetic_v<typename T::value_type>)
      for (const auto& each : part) bytes += bytes_beside(each);
    return bytes;
  } else if constexpr (requires { T::members; }) {
    return std::apply(
        [&](auto... member) { return (std::size_t{0} + ... + bytes_beside(part.*member)); },
        T::members);
  }
  return 0;
}

}  // namespace

std::size_t bytes_of(const KeptModel& model) {
  std::size_t bytes = sizeof(Model) + bytes_beside(*model.model);
  for (const auto& image : model.images)
    if (image) bytes += sizeof(ImageRgba8) + image->rgba.capacity();
  return bytes + pyramid_bytes(model) + tangent_bytes(*model.model);
}

KnownModel ReadModels::find(const std::string& id) {
  const std::lock_guard lock(mutex_);
  const Entry* const entry = models_.find(id);
  return entry == nullptr ? KnownModel{} : entry->known;
}

void ReadModels::add(const std::string& id, const KnownModel& known) {
  const std::size_t bytes = read_entry_bytes + bytes_of(*known.model) + known.text->size();
  Models::Entries surplus;
  const std::lock_guard lock(mutex_);
  if (bytes > share_.most() || models_.contains(id)) return;
  models_.add(id, {known, bytes});
  bytes_ += bytes;
  surplus = take_surplus(share_.most());
  share_.book(bytes_);
}

void ReadModels::remove(const std::string& id) {
  Models::Entries taken;
  const std::lock_guard lock(mutex_);
  if (!models_.take(id, taken)) return;
  bytes_ -= taken.front().value.bytes;
  share_.book(bytes_);
}

std::int64_t ReadModels::give_way(std::int64_t bytes) {
  Models::Entries surplus;
  const std::lock_guard lock(mutex_);
  const std::size_t before = bytes_, less = static_cast<std::size_t>(bytes);
  surplus = take_surplus(before > less ? before - less : 0);
  share_.book(bytes_);
  return static_cast<std::int64_t>(before - bytes_);
}

ReadModels::Models::Entries ReadModels::take_surplus(std::size_t most) {
  Models::Entries surplus;
  while (bytes_ > most) {
    bytes_ -= models_.last().bytes;
    models_.take_last(surplus);
  }
  return surplus;
}

std::size_t ReadModels::count() const {
  const std::lock_guard lock(mutex_);
  return models_.size();
}

std::size_t ReadModels::bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

}  // namespace tia::server
