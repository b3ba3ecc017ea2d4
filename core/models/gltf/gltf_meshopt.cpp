#include "core/models/gltf/gltf_meshopt.h"

#include "core/models/gltf/gltf_values.h"
#include "core/models/gltf/gltf_words.h"

namespace tia::gltf {
namespace {

constexpr std::array<std::string_view, 3> mode_names{"ATTRIBUTES", "TRIANGLES", "INDICES"};

void check_stride(const GltfObject& extension, const MeshoptView& view) {
  const bool indices = view.mode != MeshoptMode::attributes;
  const bool good = indices ? view.stride == 2 || view.stride == 4 : view.stride % 4 == 0;
  if (!good || !takes_stride(view.filter, view.stride))
    extension.fault(FaultKind::conflict, "byteStride", Value(static_cast<double>(view.stride)),
                    indices                                    ? "2 or 4, of indices"
                    : view.filter == MeshoptFilter::quaternion ? "8, of quaternions"
                    : view.filter == MeshoptFilter::octahedral ? "4 or 8, of unit vectors"
                                                               : "a multiple of 4");
  if (indices && view.filter != MeshoptFilter::none)
    extension.fault(FaultKind::conflict, "filter",
                    Value(meshopt_filter_names[static_cast<std::size_t>(view.filter)]),
                    "NONE, of indices");
}

void check_count(const GltfObject& extension, const MeshoptView& view, const GltfView& whole) {
  const Value count(static_cast<double>(view.count));
  if (view.mode == MeshoptMode::triangles && view.count % 3 != 0)
    extension.fault(FaultKind::out_of_range, "count", count, "a multiple of 3, of triangles");
  if (!whole.length) return;
  if (*whole.length % view.stride != 0 || *whole.length / view.stride != view.count)
    extension.fault(FaultKind::conflict, "count", count,
                    "as many of " + bytes_text(view.stride) + " as the view's " +
                        bytes_text(*whole.length) + " hold");
  if (whole.stride && *whole.stride != view.stride)
    extension.fault(FaultKind::conflict, "byteStride", Value(static_cast<double>(view.stride)),
                    std::to_string(*whole.stride) + ", as the view has");
}

}  // namespace

std::optional<MeshoptView> read_meshopt(const GltfObject& extension, const GltfView& whole) {
  const std::size_t before = extension.faults().count();
  extension.needs("buffer", "the number of a buffer");
  extension.needs("byteLength", "how many bytes are packed");
  extension.needs("byteStride", "how many bytes an element has");
  extension.needs("count", "how many elements are packed");
  extension.needs("mode", listed({mode_names.begin(), mode_names.end()}));
  MeshoptView view;
  view.packed.offset = extension.integer("byteOffset", 0, most_integer).value_or(0);
  view.packed.length = extension.integer("byteLength", 1, most_integer);
  view.stride = extension.integer("byteStride", 1, 256).value_or(4);
  view.count = extension.integer("count", 1, most_integer).value_or(1);
  view.mode = static_cast<MeshoptMode>(word(extension, "mode", mode_names).value_or(0));
  view.filter =
      static_cast<MeshoptFilter>(word(extension, "filter", meshopt_filter_names).value_or(0));
  if (extension.faults().count() != before) return std::nullopt;
  check_stride(extension, view);
  check_count(extension, view, whole);
  if (!whole.length || extension.faults().count() != before) return std::nullopt;
  return view;
}

std::optional<std::vector<std::uint8_t>> unpack(const GltfObject& extension,
                                                const MeshoptView& view) {
  constexpr std::uint64_t free_bytes = 65'536, ratio = 100;  // the codecs themselves come to 64
  const std::uint64_t size = view.count * view.stride;       // as the view says, so that it fits
  if (size > free_bytes && (size - 1) / ratio >= view.packed.bytes.size()) {
    extension.fault(FaultKind::limit, "count", Value(static_cast<double>(view.count)),
                    "at most " + std::to_string(ratio) + " bytes for each packed byte");
    return std::nullopt;
  }
  std::vector<std::uint8_t> bytes(size);
  if (!unpack_meshopt(view.mode, view.packed.bytes, view.count, view.stride, bytes)) {
    extension.fault(FaultKind::malformed, Value(bytes_text(view.packed.bytes.size())),
                    "what unpacks to " + std::to_string(view.count) + " elements of " +
                        bytes_text(view.stride));
    return std::nullopt;
  }
  apply_filter(view.filter, view.stride, bytes);
  return bytes;
}

}  // namespace tia::gltf
