#include "server/stores/scene_bytes.h"

#include <type_traits>

namespace tia::server {
namespace {

constexpr std::size_t block = 16;     // what the allocator adds to each piece
constexpr std::size_t map_node = 32;  // what a map adds to each entry

template <class T>
std::size_t heap_of(const T& value);

/// Visitor: the heap of a described object's fields.
template <class Owner>
struct FieldsHeap {
  const Owner& of;
  std::size_t bytes = 0;
  template <class Base, class Member>
  void operator()(std::string_view, Member Base::*member, const Spec&) {
    bytes += heap_of(of.*member);
  }
  template <class Base, class Variant>
  void one_of(Variant Base::*member, const Spec&) {
    bytes += heap_of(of.*member);
  }
};

std::size_t heap(const std::string& text) {
  constexpr std::size_t inside = 15;  // shorter texts stand in the string itself
  return text.capacity() > inside ? block + text.capacity() + 1 : 0;
}
template <class T>
std::size_t heap(const std::vector<T>& list) {
  std::size_t bytes = list.capacity() > 0 ? block + list.capacity() * sizeof(T) : 0;
  if constexpr (!std::is_trivially_copyable_v<T>)
    for (const T& each : list) bytes += heap_of(each);
  return bytes;
}
template <class T>
std::size_t heap(const Boxed<T>& boxed) {
  return block + sizeof(T) + heap_of(*boxed);
}
template <class T>
std::size_t heap(const OptionalBox<T>& box) {
  return box ? block + sizeof(T) + heap_of(*box) : 0;
}
// A shared list counts in full for every scene that holds it.
template <class T>
std::size_t heap(const SharedList<T>& list) {
  return block + heap_of(list.get());
}
template <class T>
std::size_t heap(const std::map<std::string, T>& map) {
  std::size_t bytes = 0;
  for (const auto& [name, value] : map)
    bytes += block + map_node + sizeof(name) + sizeof(value) + heap_of(name) + heap_of(value);
  return bytes;
}
template <class T>
std::size_t heap(const std::optional<T>& value) {
  return value ? heap_of(*value) : 0;
}
template <class... T>
std::size_t heap(const std::variant<T...>& value) {
  return std::visit([](const auto& is) { return heap_of(is); }, value);
}
std::size_t heap(const Value::Member& member) {
  return heap_of(member.first) + heap_of(member.second);
}
std::size_t heap(const Value& value) { return heap_of(value.is); }
std::size_t heap(const SharedValue& value) { return block + sizeof(Value) + heap_of(*value); }
std::size_t heap(const TransformSteps& placement) { return heap_of(placement.steps); }
template <class T>
std::size_t heap(const Numbers<T>& numbers) {
  return numbers.values.empty() ? 0 : heap_of(numbers.values);
}
std::size_t heap(const VoxelList& occupied) { return heap_of(occupied.numbers); }
std::size_t heap(const PictureFile& file) {
  return heap_of(file.base64) +
         (file.pixels ? 2 * block + sizeof(Image8) + heap_of(file.pixels->rgb) : 0);
}
std::size_t heap(const SkyFile& file) {
  return heap_of(file.base64) + (file.map ? 2 * block + file.map->bytes() : 0);
}
std::size_t heap(const AnimationKey& key) {
  return heap_of(key.value) + heap_of(key.before) + heap_of(key.after);
}
std::size_t heap(const TimeFormula& formula) { return heap_of(formula.parts); }
std::size_t heap(const ModuleRow& modules) { return heap_of(modules.at); }
std::size_t heap(const Walls& walls) {
  return heap_of(walls.points) + heap_of(walls.openings) +
         (walls.shown ? block + heap_of(*walls.shown) : 0);
}
template <Described T>
std::size_t heap(const T& value) {
  FieldsHeap<T> fields{value};
  T::fields(fields);
  return fields.bytes;
}

template <class T>
std::size_t heap_of(const T& value) {
  if constexpr (std::is_trivially_copyable_v<T>) return 0;
  else return heap(value);
}

/// Visitor: the heap of all of a scene but its objects.
struct OthersHeap {
  const Scene& of;
  std::size_t bytes = 0;
  template <class Member>
  void operator()(std::string_view, Member Scene::*member, const Spec&) {
    if constexpr (!std::is_same_v<Member, decltype(Scene::objects)>) bytes += heap_of(of.*member);
  }
};

}  // namespace

std::size_t bytes_of(const Scene& scene) { return sizeof(Scene) + heap_of(scene); }

std::size_t bytes_besides_objects(const Scene& scene) {
  OthersHeap others{scene};
  Scene::fields(others);
  return sizeof(Scene) + others.bytes;
}

}  // namespace tia::server
