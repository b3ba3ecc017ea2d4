#include "core/shapes/voxels/voxel_list.h"

#include <array>

namespace tia {
namespace {

constexpr std::array<std::string_view, 5> forms{"", "a run length", "[count, material]",
                                                "[i, j, k]", "[i, j, k, material]"};

// What the k-th number of an element may be, whatever the grid.
Spec spec_of(int width, int k) {
  const bool is_material = width % 2 == 0 && k == width - 1;
  if (is_material) return {.min = width == 2 ? 0.0 : 1.0, .max = most_cell_material};
  return {.min = 0, .max = most_cells};
}

// How many numbers it has, or 0 where it is no element.
int width_of(const Value& element) {
  if (element.as<double>() != nullptr) return 1;
  const auto* list = element.as<Value::Array>();
  return list != nullptr && list->size() >= 2 && list->size() <= 4 ? static_cast<int>(list->size())
                                                                   : 0;
}

void read_element(const Value& element, const Place& at, Faults& faults, VoxelList& to) {
  for (int k = 0; k < to.width; ++k) {
    const auto index = static_cast<std::size_t>(k);
    const auto* list = element.as<Value::Array>();
    read_value(list != nullptr ? (*list)[index] : element, list != nullptr ? at.at(index) : at,
               spec_of(to.width, k), faults, to.numbers.emplace_back());
  }
}

}  // namespace

void Codec<VoxelList>::read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                            VoxelList& out) {
  const auto* list = v.as<Value::Array>();
  if (list == nullptr || list->empty()) return detail::wrong_type(v, at, allowed(spec), faults);
  const std::size_t before = faults.count();
  VoxelList read;
  read.width = width_of(list->front());
  read.numbers.reserve(list->size() * static_cast<std::size_t>(read.width));
  for (std::size_t i = 0; i < list->size() && !faults.full(); ++i) {
    const int width = width_of((*list)[i]);
    if (width != 0 && width == read.width) read_element((*list)[i], at.at(i), faults, read);
    else if (read.width == 0)
      return detail::wrong_type((*list)[i], at.at(i), allowed(spec), faults);
    else
      detail::wrong_type(
          (*list)[i], at.at(i),
          std::string(forms[static_cast<std::size_t>(read.width)]) + ", as the first element",
          faults);
  }
  if (faults.count() == before) out = std::move(read);
}

Value Codec<VoxelList>::write(const VoxelList& v) {
  Value::Array list;
  list.reserve(v.size());
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (v.width == 1) {
      list.emplace_back(v.number(i, 0));
      continue;
    }
    Value::Array element;
    for (int k = 0; k < v.width; ++k) element.emplace_back(v.number(i, k));
    list.emplace_back(std::move(element));
  }
  return list;
}

Value Codec<VoxelList>::schema(const Spec&) {
  Value::Array lists;
  for (int width = 1; width <= 4; ++width) {
    Value::Array numbers;
    for (int k = 0; k < width; ++k) numbers.push_back(Codec<int>::schema(spec_of(width, k)));
    const Value element = width == 1 ? numbers.front()
                                     : Value(Value::Object{{"type", "array"},
                                                           {"prefixItems", numbers},
                                                           {"minItems", width},
                                                           {"maxItems", width}});
    lists.push_back(Value::Object{{"type", "array"}, {"items", element}, {"minItems", 1}});
  }
  return Value::Object{{"oneOf", lists}};
}

std::string Codec<VoxelList>::allowed(const Spec&) {
  return "a list of run lengths, by turns empty and filled, of runs [count, material], of cells "
         "[i, j, k] or of cells [i, j, k, material]";
}

}  // namespace tia
