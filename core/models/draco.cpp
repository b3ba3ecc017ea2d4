#include "core/models/draco.h"

#include <draco/attributes/attribute_octahedron_transform.h>
#include <draco/attributes/attribute_quantization_transform.h>
#include <draco/compression/decode.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace tia {
namespace {

using draco::PointAttribute;

// Whether each vertex has a value of each attribute. The library trusts its own tables.
bool has_all_values(const draco::Mesh& mesh) {
  for (std::int32_t i = 0; i < mesh.num_attributes(); ++i) {
    const PointAttribute& attribute = *mesh.attribute(i);
    if (attribute.num_components() < 1 || attribute.buffer() == nullptr) return false;
    const auto value_bytes = static_cast<std::uint64_t>(attribute.byte_stride());
    if (attribute.size() >
        attribute.buffer()->data_size() / std::max<std::uint64_t>(value_bytes, 1))
      return false;
    for (std::uint32_t point = 0; point < mesh.num_points(); ++point)
      if (attribute.mapped_index(draco::PointIndex(point)).value() >= attribute.size())
        return false;
  }
  return true;
}

bool has_good_faces(const draco::Mesh& mesh) {
  for (std::uint32_t i = 0; i < mesh.num_faces(); ++i)
    for (const draco::PointIndex& each : mesh.face(draco::FaceIndex(i)))
      if (each.value() >= mesh.num_points()) return false;
  return true;
}

// The numbers as they are packed, vertex by vertex.
template <class Number>
std::optional<std::vector<Number>> stored_values(const PointAttribute& attribute,
                                                 std::uint32_t points) {
  const auto size = static_cast<std::size_t>(attribute.num_components());
  std::vector<Number> all(points * size);
  for (std::uint32_t point = 0; point < points; ++point)
    if (!attribute.ConvertValue<Number>(attribute.mapped_index(draco::PointIndex(point)),
                                        all.data() + point * size))
      return std::nullopt;
  return all;
}

// Numbers between a least one and that plus a range, in equal steps.
// Source: Draco Bitstream Specification 2.2, section 18.1.
std::optional<std::vector<float>> dequantized(const PointAttribute& attribute,
                                              std::uint32_t points) {
  draco::AttributeQuantizationTransform transform;
  const auto stored = stored_values<std::int32_t>(attribute, points);
  const auto size = static_cast<std::size_t>(attribute.num_components());
  if (!stored || !transform.InitFromAttribute(attribute) || transform.quantization_bits() < 1 ||
      transform.quantization_bits() > 30 || transform.min_values().size() != size)
    return std::nullopt;
  const auto steps = static_cast<float>((1U << unsigned(transform.quantization_bits())) - 1);
  const float step = transform.range() / steps;
  std::vector<float> all(stored->size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = static_cast<float>((*stored)[i]) * step + transform.min_values()[i % size];
  return all;
}

// The unit vector of a point of the octahedron, unfolded onto the square from -1 to 1.
// Source: Draco Bitstream Specification 2.2, section 18.2.
void unfold(float s, float t, float* to) {
  const float x = 1 - std::fabs(s) - std::fabs(t), beyond = std::max(-x, 0.0F);
  const float y = s + (s < 0 ? beyond : -beyond), z = t + (t < 0 ? beyond : -beyond);
  const float squares = x * x + y * y + z * z;
  if (squares < 1e-6F) return;  // a vector of zeros, as the library has it
  const float scale = 1 / std::sqrt(squares);
  to[0] = x * scale;
  to[1] = y * scale;
  to[2] = z * scale;
}

std::optional<std::vector<float>> unfolded(const PointAttribute& attribute, std::uint32_t points) {
  draco::AttributeOctahedronTransform transform;
  const auto stored = stored_values<std::int32_t>(attribute, points);
  if (!stored || attribute.num_components() != 2 || !transform.InitFromAttribute(attribute) ||
      transform.quantization_bits() < 2 || transform.quantization_bits() > 30)
    return std::nullopt;
  const auto steps = static_cast<float>((1U << unsigned(transform.quantization_bits())) - 2);
  const float step = 2 / steps;
  std::vector<float> all(std::size_t{points} * 3);
  for (std::size_t i = 0; i < points; ++i)
    unfold(static_cast<float>((*stored)[i * 2]) * step - 1,
           static_cast<float>((*stored)[i * 2 + 1]) * step - 1, all.data() + i * 3);
  return all;
}

draco::AttributeTransformType transform_of(const PointAttribute& attribute) {
  const draco::AttributeTransformData* data = attribute.GetAttributeTransformData();
  return data == nullptr ? draco::ATTRIBUTE_INVALID_TRANSFORM : data->transform_type();
}

}  // namespace

std::optional<DracoMesh> DracoMesh::unpack(ModelBytes packed, std::string& why) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(packed.data()), packed.size());
  draco::Decoder decoder;
  for (int type = 0; type < draco::GeometryAttribute::NAMED_ATTRIBUTES_COUNT; ++type)
    decoder.SetSkipAttributeTransform(static_cast<draco::GeometryAttribute::Type>(type));
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) {
    why = decoded.status().error_msg_string();
    if (why.empty()) why = "bytes that cannot be unpacked";
    return std::nullopt;
  }
  std::shared_ptr<const draco::Mesh> mesh = std::move(decoded).value();
  if (has_all_values(*mesh) && has_good_faces(*mesh)) return DracoMesh(std::move(mesh));
  why = "vertices or values that are not there";
  return std::nullopt;
}

std::uint64_t DracoMesh::vertices() const { return mesh_->num_points(); }

std::vector<std::uint32_t> DracoMesh::indices() const {
  std::vector<std::uint32_t> all;
  all.reserve(std::size_t{3} * mesh_->num_faces());
  for (std::uint32_t i = 0; i < mesh_->num_faces(); ++i)
    for (const draco::PointIndex& each : mesh_->face(draco::FaceIndex(i)))
      all.push_back(each.value());
  return all;
}

const draco::PointAttribute* DracoMesh::attribute(std::uint32_t id) const {
  return mesh_->GetAttributeByUniqueId(id);
}

std::size_t DracoMesh::numbers(std::uint32_t id) const {
  const PointAttribute* const found = attribute(id);
  if (found == nullptr) return 0;
  return transform_of(*found) == draco::ATTRIBUTE_OCTAHEDRON_TRANSFORM ? 3
                                                                       : found->num_components();
}

template <class Number>
std::optional<std::vector<Number>> DracoMesh::values(std::uint32_t id) const {
  const PointAttribute& own = *attribute(id);
  const std::uint32_t points = mesh_->num_points();
  const draco::AttributeTransformType transform = transform_of(own);
  if (transform == draco::ATTRIBUTE_INVALID_TRANSFORM) return stored_values<Number>(own, points);
  if constexpr (std::is_same_v<Number, float>) {
    if (transform == draco::ATTRIBUTE_QUANTIZATION_TRANSFORM) return dequantized(own, points);
    if (transform == draco::ATTRIBUTE_OCTAHEDRON_TRANSFORM) return unfolded(own, points);
  }
  return std::nullopt;
}

template std::optional<std::vector<std::int8_t>> DracoMesh::values(std::uint32_t) const;
template std::optional<std::vector<std::uint8_t>> DracoMesh::values(std::uint32_t) const;
template std::optional<std::vector<std::int16_t>> DracoMesh::values(std::uint32_t) const;
template std::optional<std::vector<std::uint16_t>> DracoMesh::values(std::uint32_t) const;
template std::optional<std::vector<std::uint32_t>> DracoMesh::values(std::uint32_t) const;
template std::optional<std::vector<float>> DracoMesh::values(std::uint32_t) const;

}  // namespace tia
