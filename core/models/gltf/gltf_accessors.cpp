#include "core/models/gltf/gltf_accessors.h"

#include "core/models/gltf/gltf_words.h"

namespace tia::gltf {
namespace {

constexpr std::array<unsigned, 6> component_codes{5120, 5121, 5122, 5123, 5125, 5126};

std::optional<Component> component_of(const GltfObject& object, bool of_indices) {
  if (!object.needs("componentType", "the number of a component type")) return std::nullopt;
  const Value& value = *object.member("componentType");
  for (std::size_t i = 0; i < component_codes.size(); ++i) {
    const auto component = static_cast<Component>(i);
    const bool allowed = !of_indices || component == Component::unsigned_byte ||
                         component == Component::unsigned_short ||
                         component == Component::unsigned_int;
    if (allowed && value == Value(static_cast<double>(component_codes[i]))) return component;
  }
  object.fault(value.as<double>() == nullptr ? FaultKind::wrong_type : FaultKind::out_of_range,
               "componentType", excerpt(value),
               of_indices ? "5121, 5123 or 5125" : "5120, 5121, 5122, 5123, 5125 or 5126");
  return std::nullopt;
}

// One accessor, or a sparse one's lists, in its view.
struct Placed {
  const GltfObject& object;
  const GltfView& view;
  std::uint64_t count;
  std::size_t stride, element, component;  // of these many bytes
};

// Faults are where gltf-validator has them.
bool refuse_placed(const Placed& placed, bool at_offset, std::uint64_t got, std::string allowed) {
  Value value(static_cast<double>(got));
  if (at_offset)
    placed.object.fault(FaultKind::out_of_range, "byteOffset", std::move(value),
                        std::move(allowed));
  else placed.object.fault(FaultKind::out_of_range, std::move(value), std::move(allowed));
  return false;
}

// Whether `count` elements from the offset on lie in the view, each number at a multiple of its
// size.
bool lies_in_view(const Placed& placed, std::uint64_t offset) {
  const std::uint64_t length = *placed.view.length;
  const std::string multiple = "a multiple of " + std::to_string(placed.component);
  if (offset % placed.component != 0) return refuse_placed(placed, true, offset, multiple);
  if (placed.view.offset % placed.component != 0)
    return refuse_placed(placed, false, placed.view.offset, "in a view at " + multiple + " bytes");
  if (offset > length)
    return refuse_placed(placed, true, offset, "an offset in the view of " + bytes_text(length));
  const std::uint64_t left = length - offset;
  if (left < placed.element || placed.count - 1 > (left - placed.element) / placed.stride)
    return refuse_placed(placed, false, placed.count,
                         "as many elements as the view's " + bytes_text(left) +
                             " from there on hold, each of " + bytes_text(placed.stride));
  return true;
}

std::optional<std::uint64_t> offset_of(const GltfObject& object) {
  return object.has("byteOffset") ? object.integer("byteOffset", 0, most_integer)
                                  : std::optional<std::uint64_t>(0);
}

// The bytes of packed elements, an object's `bufferView` and `byteOffset`; none and a fault else.
std::optional<ModelBytes> packed_bytes(const GltfObject& object, const std::vector<GltfView>& views,
                                       const ElementLayout& layout, std::uint64_t count) {
  object.needs("bufferView", "the number of a view");
  const MaybeIndex index = object.index("bufferView", views.size());
  const auto offset = offset_of(object);
  if (!index || !offset || !views[*index].length) return std::nullopt;
  const GltfView& view = views[*index];
  const Placed placed{object,          view,           count,
                      layout.stride(), layout.bytes(), size_of(layout.component)};
  if (!lies_in_view(placed, *offset) || !view.there) return std::nullopt;
  return view.bytes.subspan(*offset, (count - 1) * layout.stride() + layout.bytes());
}

bool read_sparse(const GltfObject& object, const std::vector<GltfView>& views, Accessor& accessor) {
  SparseElements sparse;
  for (const auto name : {"count", "indices", "values"})
    object.needs(name, "a sparse accessor's count, indices and values");
  const auto count = object.integer("count", 1, accessor.count);
  bool good = count.has_value();
  sparse.count = count.value_or(1);
  good &= object.with("indices", [&](const GltfObject& indices) {
    const auto component = component_of(indices, true);
    sparse.component = component.value_or(Component::unsigned_byte);  // the least bytes
    const auto bytes = packed_bytes(indices, views, {sparse.component}, sparse.count);
    good &= component && bytes;
    if (bytes) sparse.indices = *bytes;
  });
  good &= object.with("values", [&](const GltfObject& values) {
    const auto bytes = packed_bytes(values, views, accessor.layout, sparse.count);
    good &= bytes.has_value();
    if (bytes) sparse.values = *bytes;
  });
  accessor.sparse = sparse;
  return good;
}

constexpr std::array<std::string_view, 7> type_names{"SCALAR", "VEC2", "VEC3", "VEC4",
                                                     "MAT2",   "MAT3", "MAT4"};
constexpr std::array<std::array<std::size_t, 2>, 7> type_shapes{
    {{1, 1}, {2, 1}, {3, 1}, {4, 1}, {2, 2}, {3, 3}, {4, 4}}};  // rows, columns

bool read_type(const GltfObject& object, Accessor& accessor) {
  if (!object.needs("type", "the name of a type")) return false;
  const std::size_t before = object.faults().count();
  const std::string name = object.text("type");
  for (std::size_t i = 0; i < type_names.size(); ++i) {
    if (name != type_names[i]) continue;
    accessor.type = static_cast<ElementType>(i);
    accessor.layout.rows = type_shapes[i][0];
    accessor.layout.columns = type_shapes[i][1];
    return true;
  }
  if (object.faults().count() == before)
    object.fault(FaultKind::out_of_range, "type", excerpt(name),
                 listed({type_names.begin(), type_names.end()}));
  return false;
}

bool read_layout(const GltfObject& object, Accessor& accessor) {
  const auto component = component_of(object, false);
  const bool typed = read_type(object, accessor);
  ElementLayout& layout = accessor.layout;
  layout.normalized = object.flag("normalized", false);
  object.needs("count", "how many elements");
  const auto count = object.integer("count", 1, most_integer);
  if (!component || !typed || !count) return false;
  layout.component = *component;
  accessor.count = *count;
  if (layout.normalized && size_of(*component) == 4) {
    object.fault(FaultKind::conflict, "normalized", Value(true),
                 "false with floats and 4-byte integers");
    return false;
  }
  return true;
}

// Where it lies. Without a view its count costs no bytes, so that it has a limit.
bool place(const GltfObject& object, const std::vector<GltfView>& views, const ModelLimits& limits,
           Accessor& accessor) {
  const ElementLayout& layout = accessor.layout;
  accessor.stride = layout.stride();
  if (!object.has("bufferView")) {
    if (object.has("byteOffset"))
      object.fault(FaultKind::conflict, "byteOffset", std::nullopt, "none without a bufferView");
    else if (accessor.count > limits.vertices)
      object.fault(FaultKind::limit, "count", Value(static_cast<double>(accessor.count)),
                   "at most " + std::to_string(limits.vertices) + " elements without a view");
    else return true;
    return false;
  }
  const MaybeIndex index = object.index("bufferView", views.size());
  const auto offset = offset_of(object);
  if (!index || !offset || !views[*index].length) return false;
  const GltfView& view = views[*index];
  accessor.strided = view.stride.has_value();
  if (view.stride) accessor.stride = *view.stride;
  accessor.in_fours = *offset % 4 == 0 && accessor.stride % 4 == 0;
  if (accessor.stride < layout.bytes())
    return refuse_placed(
        {object, view, 0, 0, 0, 0}, false, accessor.stride,
        "in a view of a byteStride from " + std::to_string(layout.bytes()) + " on");
  const Placed placed{object,          view,           accessor.count,
                      accessor.stride, layout.bytes(), size_of(layout.component)};
  if (!lies_in_view(placed, *offset) || !view.there) return false;
  accessor.bytes =
      view.bytes.subspan(*offset, (accessor.count - 1) * accessor.stride + layout.bytes());
  return true;
}

std::string type_words(ElementTypes types) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < type_names.size(); ++i)
    if ((types >> i & 1U) != 0) names.push_back(type_names[i]);
  return listed(names);
}

std::string format_words(Formats formats) {
  constexpr std::array<std::string_view, 12> names{"BYTE",           "BYTE normalized",
                                                   "UNSIGNED_BYTE",  "UNSIGNED_BYTE normalized",
                                                   "SHORT",          "SHORT normalized",
                                                   "UNSIGNED_SHORT", "UNSIGNED_SHORT normalized",
                                                   "UNSIGNED_INT",   "",
                                                   "FLOAT",          ""};
  std::vector<std::string_view> allowed;
  for (std::size_t i = 0; i < names.size(); ++i)
    if ((formats >> i & 1U) != 0) allowed.push_back(names[i]);
  return listed(allowed);
}

}  // namespace

std::vector<Accessor> read_accessors(const GltfObject& root, const std::vector<GltfView>& views,
                                     const ModelLimits& limits) {
  std::vector<Accessor> all;
  all.reserve(root.size_of("accessors"));
  root.for_each("accessors", [&](const GltfObject& object, std::size_t number) {
    Accessor accessor;
    accessor.index = static_cast<ModelIndex>(number);
    accessor.good = read_layout(object, accessor) && place(object, views, limits, accessor);
    object.with("sparse", [&](const GltfObject& sparse) {
      if (accessor.count > 0) accessor.good &= read_sparse(sparse, views, accessor);
    });
    all.push_back(accessor);
  });
  return all;
}

bool fits(const Accessor& accessor, const AccessorRule& rule) {
  const ElementLayout& layout = accessor.layout;
  return (rule.types & only(accessor.type)) != 0 &&
         (rule.formats & format(layout.component, layout.normalized)) != 0;
}

std::string words(const AccessorRule& rule) {
  return type_words(rule.types) + " of " + format_words(rule.formats);
}

std::string words(const Accessor& accessor) {
  const ElementLayout& layout = accessor.layout;
  return "accessor " + std::to_string(accessor.index) + ": " +
         words(AccessorRule{only(accessor.type), format(layout.component, layout.normalized)});
}

}  // namespace tia::gltf
