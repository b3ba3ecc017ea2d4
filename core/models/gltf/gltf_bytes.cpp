#include "core/models/gltf/gltf_bytes.h"

#include "core/models/gltf/gltf_meshopt.h"
#include "core/models/gltf/gltf_words.h"

namespace tia::gltf {
namespace {

constexpr std::uint64_t index_target = 34963;  // ELEMENT_ARRAY_BUFFER

void read_stride(const GltfObject& object, GltfView& view) {
  const auto target = object.integer("target", 0, most_integer);
  view.stride = object.integer("byteStride", 4, 252);
  if (!view.stride) return;
  const auto refuse = [&](std::string allowed) {
    object.fault(FaultKind::out_of_range, "byteStride", Value(static_cast<double>(*view.stride)),
                 std::move(allowed));
  };
  if (*view.stride % 4 != 0) refuse("a multiple of 4");
  else if (view.length && *view.stride > *view.length) refuse("at most the view's byteLength");
  else if (target == index_target) refuse("none in a view of indices");
}

// Whether the view lies in its buffer.
bool lies_within(const GltfObject& object, const GltfView& view, std::uint64_t buffer) {
  const auto refuse = [&](std::string_view name, std::uint64_t got, std::uint64_t most) {
    object.fault(FaultKind::out_of_range, name, Value(static_cast<double>(got)),
                 "at most " + std::to_string(most) + ": the buffer has " + bytes_text(buffer));
    return false;
  };
  if (view.offset >= buffer) return refuse("byteOffset", view.offset, buffer - 1);
  if (*view.length > buffer - view.offset)
    return refuse("byteLength", *view.length, buffer - view.offset);
  return true;
}

}  // namespace

GltfBytes::GltfBytes(const GltfObject& root, const GltfCame& came, Model& model) {
  // Each may ask for a file by its name, which is looked for among all that came.
  constexpr std::size_t most_buffers = 4096;
  if (const std::size_t count = root.size_of("buffers"); count > most_buffers) {
    root.fault(FaultKind::limit, "buffers", Value(static_cast<double>(count)),
               "at most " + std::to_string(most_buffers) + " buffers");
    return;
  }
  for (const ModelFile& file : came.files.all) packed_left_ += file.bytes.size();
  root.for_each("buffers", [&](const GltfObject& object, std::size_t number) {
    read_buffer(object, number, came, model);
  });
  root.for_each("bufferViews", [&](const GltfObject& object, std::size_t) { read_view(object); });
  accessors_ = read_accessors(root, views_, came.limits);
}

std::optional<ModelBytes> GltfBytes::buffer_bytes(const GltfObject& object, std::size_t number,
                                                  const GltfCame& came) {
  Faults& faults = object.faults();
  if (object.has("uri")) {
    const std::size_t before = faults.count();
    const std::string uri = object.text("uri");
    std::vector<std::uint8_t> own;
    const Place place = object.at().at("uri");
    if (faults.count() != before) return std::nullopt;
    const ModelBytes bytes = uri_bytes(came.files, uri, place, faults, own);
    if (faults.count() != before) return std::nullopt;
    if (!own.empty()) decoded_.push_back(std::move(own));  // moved, its bytes stay where they are
    return bytes;
  }
  if (number == 0 && came.bin) return came.bin;
  if (object.there())
    object.fault(FaultKind::missing, "uri", std::nullopt,
                 "a file's name or a data URI, but for a GLB's first buffer");
  return std::nullopt;
}

void GltfBytes::read_buffer(const GltfObject& object, std::size_t number, const GltfCame& came,
                            Model& model) {
  Buffer buffer;
  object.needs("byteLength", "how many bytes the buffer has");
  buffer.length = object.integer("byteLength", 1, most_integer);
  object.with_extension(meshopt_name, [&](const GltfObject& extension) {
    buffer.fallback = extension.flag("fallback", false);
  });
  const std::optional<ModelBytes> bytes =
      buffer.fallback ? std::nullopt : buffer_bytes(object, number, came);
  if (bytes && buffer.length) {
    const std::uint64_t length = *buffer.length;
    buffer.there = length <= bytes->size();
    if (buffer.there) buffer.bytes = bytes->first(length);
    else
      object.fault(FaultKind::malformed, Value(bytes_text(bytes->size())),
                   bytes_text(length) + ", as its byteLength says");
    if (buffer.there && !object.has("uri") && bytes->size() - length > 3)
      model.warn({object.at().pointer(), 0,
                  bytes_text(bytes->size() - length) + " of the GLB's are in no buffer"});
  }
  buffers_.push_back(buffer);
}

void GltfBytes::read_view(const GltfObject& object) {
  GltfView view;
  object.needs("buffer", "the number of a buffer");
  object.needs("byteLength", "how many bytes the view has");
  const MaybeIndex index = object.index("buffer", buffers_.size());
  const bool placed = !object.has("byteOffset");
  const auto offset = object.integer("byteOffset", 0, most_integer);
  view.offset = offset.value_or(0);
  view.length = object.integer("byteLength", 1, most_integer);
  read_stride(object, view);
  if (index && (placed || offset)) place_view(object, *index, view);
  const bool packed = object.with_extension(
      meshopt_name, [&](const GltfObject& extension) { unpack_view(extension, view); });
  if (index && !packed && buffers_[*index].fallback)
    object.fault(FaultKind::conflict, "buffer", Value(static_cast<double>(*index)),
                 "a buffer that is no fallback, without " + std::string(meshopt_name));
  views_.push_back(view);
}

void GltfBytes::place_view(const GltfObject& object, std::size_t number, GltfView& view) const {
  const Buffer& buffer = buffers_[number];
  view.there =
      view.length && buffer.length && lies_within(object, view, *buffer.length) && buffer.there;
  if (view.there) view.bytes = buffer.bytes.subspan(view.offset, *view.length);
}

// Views may overlap, so that what is unpacked is counted.
void GltfBytes::unpack_view(const GltfObject& extension, GltfView& view) {
  const auto buffer = extension.index("buffer", buffers_.size());
  auto own = read_meshopt(extension, view);
  view.there = false;
  if (!buffer || !own) return;
  if (buffers_[*buffer].fallback)
    return extension.fault(FaultKind::conflict, "buffer", Value(static_cast<double>(*buffer)),
                           "a buffer that is no fallback");
  place_view(extension, *buffer, own->packed);
  if (!own->packed.there) return;
  const std::uint64_t size = own->packed.bytes.size();
  if (size > packed_left_)
    return extension.fault(FaultKind::limit, Value(bytes_text(size) + " more"),
                           "packed views of at most as many bytes together as came");
  packed_left_ -= size;
  auto bytes = unpack(extension, *own);
  if (!bytes) return;
  decoded_.push_back(std::move(*bytes));  // moved, they stay where they are
  view.bytes = decoded_.back();
  view.there = true;
}

ModelBytes view_bytes(const GltfSource& source, ModelIndex view, const Place& at) {
  const std::vector<GltfView>& views = source.bytes.views();
  if (view < views.size()) return views[view].bytes;
  source.faults.add({FaultKind::out_of_range, at.pointer(), Value(static_cast<double>(view)),
                     "the number of one of the " + std::to_string(views.size()) + " views"});
  return {};
}

const Accessor* accessor_for(const GltfSource& source, const GltfObject& owner,
                             std::string_view name, const AccessorRule& rule) {
  const std::vector<Accessor>& all = source.bytes.accessors();
  const MaybeIndex index = owner.index(name, all.size());
  if (!index || !all[*index].good) return nullptr;
  const Accessor& accessor = all[*index];
  if (fits(accessor, rule)) return &accessor;
  owner.fault(FaultKind::wrong_type, name, Value(words(accessor)), words(rule));
  return nullptr;
}

}  // namespace tia::gltf
