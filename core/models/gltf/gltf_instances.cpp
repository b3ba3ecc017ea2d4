#include "core/models/gltf/gltf_instances.h"

#include "core/models/gltf/gltf_attributes.h"
#include "core/models/gltf/gltf_bytes.h"

namespace tia::gltf {
namespace {

constexpr AccessorRule moved_rule{only(ElementType::vec3), floats};
constexpr AccessorRule turned_rule{
    only(ElementType::vec4),
    any_of({floats, format(Component::signed_byte, true), format(Component::signed_short, true)})};

struct InstanceAccessor {
  const Accessor* accessor = nullptr;
  std::string_view name;
};

std::vector<double> read_of_instances(const GltfSource& source, const InstanceAccessor& from) {
  if (from.accessor == nullptr) return {};
  auto read = read_elements<double>(source, *from.accessor, from.accessor->count, farthest);
  return read ? std::move(*read) : std::vector<double>();
}

std::vector<Placement> placements(const std::vector<double>& moved,
                                  const std::vector<double>& turned,
                                  const std::vector<double>& scaled, std::size_t count) {
  std::vector<Placement> all(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t three = i * 3, four = i * 4;
    if (!moved.empty()) all[i].translation = {moved[three], moved[three + 1], moved[three + 2]};
    if (!turned.empty())
      all[i].rotation = {turned[four], turned[four + 1], turned[four + 2], turned[four + 3]};
    if (!scaled.empty()) all[i].scale = {scaled[three], scaled[three + 1], scaled[three + 2]};
  }
  return all;
}

// Without a length it turns nothing anywhere.
void check_turned(const GltfObject& attributes, const std::vector<double>& turned) {
  for (std::size_t i = 0; i < turned.size(); i += 4) {
    if (turned[i] != 0 || turned[i + 1] != 0 || turned[i + 2] != 0 || turned[i + 3] != 0) continue;
    return attributes.fault(
        FaultKind::out_of_range, "ROTATION", std::nullopt,
        "quaternions that are not zero, as number " + std::to_string(i / 4) + " is");
  }
}

// How many they are: as many in each list.
std::optional<std::uint64_t> count_of(const GltfObject& attributes,
                                      const std::array<InstanceAccessor, 3>& lists) {
  std::optional<std::uint64_t> count;
  for (const InstanceAccessor& list : lists) {
    if (list.accessor == nullptr) continue;
    if (count.value_or(list.accessor->count) != list.accessor->count) {
      attributes.fault(FaultKind::conflict, list.name,
                       Value(static_cast<double>(list.accessor->count)),
                       std::to_string(*count) + " elements, as many as the others have");
      return std::nullopt;
    }
    count = list.accessor->count;
  }
  return count;
}

std::vector<Placement> read_placements(const GltfSource& source, const GltfObject& attributes,
                                       std::uint64_t& left) {
  const auto list = [&](std::string_view name, const AccessorRule& rule) {
    return InstanceAccessor{accessor_for(source, attributes, name, rule), name};
  };
  const std::array lists{list("TRANSLATION", moved_rule), list("ROTATION", turned_rule),
                         list("SCALE", moved_rule)};
  const auto count = count_of(attributes, lists);
  if (!count) return {};
  if (*count > left) {
    attributes.fault(FaultKind::limit, Value(static_cast<double>(*count)),
                     "at most " + std::to_string(source.limits.instances) + " instances in all");
    return {};
  }
  left -= *count;
  const std::vector<double> moved = read_of_instances(source, lists[0]),
                            turned = read_of_instances(source, lists[1]),
                            scaled = read_of_instances(source, lists[2]);
  check_turned(attributes, turned);
  return placements(moved, turned, scaled, *count);
}

}  // namespace

std::vector<Placement> read_instances(const GltfSource& source, const GltfObject& node,
                                      std::uint64_t& left) {
  std::vector<Placement> all;
  node.with_extension("EXT_mesh_gpu_instancing", [&](const GltfObject& extension) {
    extension.needs("attributes", "an object of accessors");
    extension.with("attributes", [&](const GltfObject& attributes) {
      all = read_placements(source, attributes, left);
    });
  });
  return all;
}

}  // namespace tia::gltf
