#include "core/models/gltf/gltf_attributes.h"

#include <algorithm>
#include <cmath>

#include "core/models/gltf/gltf_bytes.h"

namespace tia::gltf {
namespace {

using enum Component;

constexpr Formats normalized_units =
    any_of({format(unsigned_byte, true), format(unsigned_short, true)});
constexpr Formats normalized_directions =
    any_of({format(signed_byte, true), format(signed_short, true)});
constexpr Formats integers = any_of(
    {format(signed_byte), format(unsigned_byte), format(signed_short), format(unsigned_short)});

// Source: Khronos, glTF 2.0 (2021), section 3.7.2.1, and KHR_mesh_quantization.
constexpr AttributeRule position_rule{only(ElementType::vec3), floats,
                                      any_of({integers, normalized_units, normalized_directions})};
constexpr AttributeRule normal_rule{only(ElementType::vec3), floats, normalized_directions};
constexpr AttributeRule tangent_rule{only(ElementType::vec4), floats, normalized_directions};
constexpr AttributeRule uv_rule{only(ElementType::vec2), any_of({floats, normalized_units}),
                                any_of({integers, normalized_directions})};
constexpr AttributeRule color_rule{
    static_cast<ElementTypes>(only(ElementType::vec3) | only(ElementType::vec4)),
    any_of({floats, normalized_units})};
constexpr AttributeRule joints_rule{only(ElementType::vec4),
                                    any_of({format(unsigned_byte), format(unsigned_short)})};
constexpr AttributeRule weights_rule{only(ElementType::vec4), any_of({floats, normalized_units})};

constexpr std::array<std::string_view, 9> taken_attributes{"POSITION",   "NORMAL",     "TANGENT",
                                                           "TEXCOORD_0", "TEXCOORD_1", "COLOR_0",
                                                           "JOINTS_0",   "WEIGHTS_0",  "JOINTS_1"};

void warn_at(const Attributes& attributes, std::string_view name, std::string text) {
  attributes.model.warn({attributes.object.at().at(name).pointer(), 0, std::move(text)});
}

// Of `stride` numbers each, whether one has three zeros in front.
bool has_no_length(const std::vector<float>& vectors, std::size_t stride) {
  for (std::size_t i = 0; i < vectors.size(); i += stride)
    if (vectors[i] == 0 && vectors[i + 1] == 0 && vectors[i + 2] == 0) return true;
  return false;
}

bool has_a_side(const std::vector<float>& tangents) {
  for (std::size_t i = 3; i < tangents.size(); i += 4)
    if (std::fabs(tangents[i]) != 1) return false;
  return true;
}

// Normals and tangents come from faces and uvs where those of the file are none.
void read_frames(const Attributes& attributes, ModelPart& part) {
  part.normals = read_attribute<float>(attributes, "NORMAL", normal_rule);
  part.tangents = read_attribute<float>(attributes, "TANGENT", tangent_rule);
  if (has_no_length(part.normals, 3)) {
    warn_at(attributes, "NORMAL", "a normal has no length: none of these are used");
    part.normals.clear();
  }
  if (part.tangents.empty()) return;
  if (has_no_length(part.tangents, 4) || !has_a_side(part.tangents))
    warn_at(attributes, "TANGENT", "a tangent has no length or no side: none of these are used");
  else if (part.normals.empty())
    warn_at(attributes, "TANGENT", "tangents are not used without normals");
  else return;
  part.tangents.clear();
}

// Three numbers are a colour, four have its alpha. glTF has all within 0 and 1.
std::vector<float> read_colors(const Attributes& attributes) {
  const std::vector<float> read = read_attribute<float>(attributes, "COLOR_0", color_rule);
  const std::size_t size = attributes.vertices == 0 ? 0 : read.size() / attributes.vertices;
  std::vector<float> colors;
  colors.reserve(read.empty() ? 0 : attributes.vertices * 4);
  for (std::size_t i = 0; i < read.size(); i += size)
    for (std::size_t c = 0; c < 4; ++c)
      colors.push_back(c < size ? std::clamp(read[i + c], 0.0F, 1.0F) : 1);
  return colors;
}

// Four numbers a vertex of each list, in turn; of one alone that list.
template <class Number>
std::vector<Number> in_turn(std::vector<Number> first, const std::vector<Number>& second) {
  if (second.size() != first.size()) return first;
  std::vector<Number> both;
  both.reserve(first.size() * 2);
  for (std::size_t i = 0; i < first.size(); i += 4) {
    both.insert(both.end(), first.data() + i, first.data() + i + 4);
    both.insert(both.end(), second.data() + i, second.data() + i + 4);
  }
  return both;
}

void check_weights(const Attributes& attributes, std::string_view name,
                   const std::vector<float>& weights) {
  const auto wrong =
      std::ranges::find_if(weights, [](float weight) { return weight < 0 || weight > 1e6F; });
  if (wrong != weights.end())
    attributes.object.fault(FaultKind::out_of_range, name, Value(double{*wrong}),
                            "weights from 0 to 1e6");
}

void read_skin(const Attributes& attributes, ModelPart& part) {
  for (const auto [joints, weights] :
       {std::array{"JOINTS_0", "WEIGHTS_0"}, std::array{"JOINTS_1", "WEIGHTS_1"}})
    if (attributes.object.has(joints) != attributes.object.has(weights))
      return attributes.object.fault(FaultKind::conflict, std::nullopt,
                                     std::string(joints) + " and " + weights + ", or neither");
  const auto joints = [&](std::string_view name) {
    return read_attribute<std::uint32_t>(attributes, name, joints_rule);
  };
  const auto weights = [&](std::string_view name) {
    std::vector<float> read = read_attribute<float>(attributes, name, weights_rule);
    check_weights(attributes, name, read);
    return read;
  };
  if (!attributes.object.has("JOINTS_0")) return;
  part.joints = in_turn(joints("JOINTS_0"), joints("JOINTS_1"));
  part.weights = in_turn(weights("WEIGHTS_0"), weights("WEIGHTS_1"));
}

// What is not taken has to fit as well.
void check_others(const Attributes& attributes) {
  attributes.object.for_each_member([&](std::string_view name, const Value&) {
    if (name == "WEIGHTS_1" || std::ranges::find(taken_attributes, name) != taken_attributes.end())
      return;
    constexpr AttributeRule any{0xFF, 0xFFFF, 0};
    if (attribute_accessor(attributes, name, any) != nullptr && !name.starts_with('_'))
      warn_at(attributes, name, "this attribute is not taken");
  });
}

}  // namespace

const Accessor* attribute_accessor(const Attributes& attributes, std::string_view name,
                                   const AttributeRule& rule) {
  const auto formats =
      static_cast<Formats>(rule.formats | (attributes.quantized ? rule.quantized : 0));
  const Accessor* accessor =
      accessor_for(attributes.source, attributes.object, name, {rule.types, formats});
  if (accessor == nullptr) return nullptr;
  if (attributes.unpacked != nullptr)
    if (const Accessor* own = attributes.unpacked->find(name)) accessor = own;
  if (accessor->count != attributes.vertices)
    attributes.object.fault(FaultKind::conflict, name,
                            Value(std::to_string(accessor->count) + " elements"),
                            std::to_string(attributes.vertices) + ", as many as of POSITION");
  else if (!accessor->bytes.empty() && !accessor->in_fours)
    attributes.object.fault(FaultKind::out_of_range, name, std::nullopt,
                            "an accessor whose byteOffset and stride are multiples of 4");
  else return accessor;
  return nullptr;
}

void read_vertices(const Attributes& attributes, ModelPart& part) {
  part.positions = read_attribute<double>(attributes, "POSITION", position_rule);
  read_frames(attributes, part);
  for (std::size_t set = 0; set < 2; ++set)
    part.uvs[set] =
        read_attribute<double>(attributes, set == 0 ? "TEXCOORD_0" : "TEXCOORD_1", uv_rule);
  part.colors = read_colors(attributes);
  read_skin(attributes, part);
  check_others(attributes);
}

}  // namespace tia::gltf
