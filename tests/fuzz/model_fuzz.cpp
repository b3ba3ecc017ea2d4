// Any bytes as a model: it has faults, or it fits together, goes through an archive and back, and
// can be posed and described. Behind a record separator stands what the file names. Archives and
// flat forms likewise.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/models/archive.h"
#include "core/models/check_model.h"
#include "core/models/describe.h"
#include "core/models/formats.h"
#include "core/models/images.h"
#include "core/models/pose.h"
#include "core/models/zip.h"

namespace {

using namespace tia;

void must(bool holds) {
  if (!holds) std::abort();
}

constexpr ModelLimits few{.triangles = 100'000,
                          .vertices = 100'000,
                          .nodes = 1000,
                          .depth = 32,
                          .instances = 10'000,
                          .polygon_corners = 256,
                          .json_values = 20'000,
                          .texture_pixels = 100'000};

bool fits(const Model& model) {
  Faults faults;
  check_model(model, few, faults);
  return faults.empty();
}

void use(const Model& model) {
  const ModelMoment last{{}, model.animations.empty() ? MaybeIndex() : MaybeIndex(0), 0.5};
  bounds_of(model, pose_of(model, last));
  description_of(model);
  Faults faults;
  decode_images(model, few, faults);
}

void read(const ModelFiles& files) {
  try {
    const Model model = read_model(files, few);
    must(fits(model));
    std::vector<std::uint8_t> bytes;
    write_archive(model,
                  [&](ModelBytes piece) { bytes.insert(bytes.end(), piece.begin(), piece.end()); });
    const auto back = unarchived(bytes);
    must(back.has_value() && *back == model);
    use(model);
  } catch (const InputError& error) {
    must(!error.faults().empty());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ModelBytes all(data, size);
  const auto end = static_cast<std::size_t>(std::find(data, data + size, 0x1E) - data);
  const ModelBytes named = all.subspan(std::min(size, end + 1));
  read({{{"a", all.first(end)}, {"a.mtl", named}, {"a.bin", named}, {"a.png", named}}, 0});
  if (end < size) read({{{"a", all}}, 0});
  if (is_zip(all)) {
    Faults faults;
    const std::vector<UnpackedFile> files = unpack_zip(all, {1 << 20, 16, 100}, faults);
    must(faults.empty() || files.empty());
    for (const UnpackedFile& each : files) read({{{each.path, each.bytes}}, 0});
  }
  if (const auto model = unarchived(all))
    if (fits(*model)) use(*model);
  return 0;
}
