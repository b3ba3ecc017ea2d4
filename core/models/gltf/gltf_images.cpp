#include "core/models/gltf/gltf_images.h"

#include <map>
#include <numeric>
#include <utility>

#include "core/models/images.h"

namespace tia::gltf {
namespace {

/// ImageFiles: takes the images' bytes into the model. Views may overlap and be named again and
/// again, so that what is copied is counted.
class ImageFiles {
 public:
  ImageFiles(const GltfSource& source, Model& model) : source_(&source), model_(&model) {
    for (const ModelFile& file : source.files.all) most_ += file.bytes.size();
  }

  /// The number of the image that holds its bytes.
  ModelIndex take(const GltfObject& image, ModelIndex number) {
    std::vector<std::uint8_t> own;
    const std::size_t before = source_->faults.count();
    const ModelBytes bytes = bytes_of(image, own);
    if (source_->faults.count() != before) return number;
    if (bytes.empty() && !source_->faults.empty()) return number;  // a view without its buffer
    if (!is_image(bytes)) {
      add(FaultKind::wrong_type, image, "bytes that begin like none",
          "a PNG, JPEG or WebP picture");
      return number;
    }
    if (own.empty()) {
      const auto [first, is_new] = first_.emplace(bytes.data(), number);
      const auto& held = model_->images[first->second].file;
      if (!is_new && held.size() == bytes.size()) return first->second;
    }
    if (!fits(image, bytes.size())) return number;
    auto& file = model_->images[number].file;
    if (own.empty()) file.assign(bytes.begin(), bytes.end());
    else file = std::move(own);
    return number;
  }

 private:
  ModelBytes bytes_of(const GltfObject& image, std::vector<std::uint8_t>& own) const {
    const bool has_uri = image.has("uri"), has_view = image.has("bufferView");
    if (has_uri == has_view) {
      add(has_uri ? FaultKind::conflict : FaultKind::missing, image, std::nullopt,
          "a uri or a bufferView");
    } else if (has_uri) {
      const Place at = image.at().at("uri");
      const std::size_t before = source_->faults.count();
      const std::string uri = image.text("uri");
      if (source_->faults.count() == before)
        return uri_bytes(source_->files, uri, at, source_->faults, own);
    } else if (const auto view = image.index("bufferView", source_->root.size_of("bufferViews"))) {
      return view_bytes(*source_, *view, image.at().at("bufferView"));
    }
    return {};
  }

  bool fits(const GltfObject& image, std::size_t size) {
    if (size <= most_ - held_) {
      held_ += size;
      return true;
    }
    add(FaultKind::limit, image, Value(std::to_string(size) + " bytes more"),
        "images of at most " + std::to_string(most_) + " bytes together, as many as came");
    return false;
  }

  void add(FaultKind kind, const GltfObject& image, std::optional<Value> got,
           std::string allowed) const {
    source_->faults.add({kind, image.at().pointer(), std::move(got), std::move(allowed)});
  }

  const GltfSource* source_;
  Model* model_;
  std::uint64_t most_ = 0, held_ = 0;
  std::map<const std::uint8_t*, ModelIndex> first_;  // by where its bytes begin
};

}  // namespace

std::vector<ModelIndex> read_images(const GltfSource& source, const std::vector<bool>& wanted,
                                    Model& model) {
  std::vector<ModelIndex> holders(wanted.size());
  std::iota(holders.begin(), holders.end(), ModelIndex{0});
  model.images.resize(wanted.size());
  ImageFiles files(source, model);
  source.root.for_each("images", [&](const GltfObject& image, std::size_t i) {
    model.images[i].name = image.text("name");
    if (wanted[i] && image.there()) holders[i] = files.take(image, static_cast<ModelIndex>(i));
  });
  return holders;
}

}  // namespace tia::gltf
