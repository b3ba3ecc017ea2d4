#include "core/models/gltf/gltf_uses.h"

namespace tia::gltf {
namespace {

enum class ViewUse : std::uint8_t { none, vertices, indices, other };
constexpr std::array<std::string_view, 4> use_words{"nothing", "vertices", "indices",
                                                    "other things than vertices and indices"};

class ViewUses {
 public:
  explicit ViewUses(const GltfObject& root) {
    root.for_each("bufferViews", [&](const GltfObject& view, std::size_t) {
      constexpr double vertices = 34962, indices = 34963;  // ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER
      const double target = view.number_or("target", 0);
      views_.push_back({target == vertices  ? ViewUse::vertices
                        : target == indices ? ViewUse::indices
                                            : ViewUse::none,
                        view.has("byteStride")});
    });
    root.for_each("accessors", [&](const GltfObject& accessor, std::size_t) {
      accessors_.push_back(accessor.index("bufferView", views_.size()));
      accessor.with("sparse", [&](const GltfObject& sparse) {
        for (const auto name : {"indices", "values"})
          sparse.with(name, [&](const GltfObject& list) { take_sparse(list); });
      });
    });
  }

  /// The use of an accessor that a member names.
  void take(const GltfObject& owner, std::string_view name, ViewUse use) {
    const MaybeIndex accessor = owner.index(name, accessors_.size());
    if (accessor) take(owner, name, accessors_[*accessor], use);
  }
  /// The use of a view that a member names.
  void take_view(const GltfObject& owner, ViewUse use) {
    take(owner, "bufferView", owner.index("bufferView", views_.size()), use);
  }

 private:
  struct View {
    ViewUse use;
    bool strided;
  };

  void take_sparse(const GltfObject& list) {
    const MaybeIndex view = list.index("bufferView", views_.size());
    if (view && views_[*view].strided)
      list.fault(FaultKind::conflict, "bufferView",
                 Value("view " + std::to_string(*view) + ", which has a byteStride"),
                 "a view without a byteStride");
    take_view(list, ViewUse::other);
  }

  void take(const GltfObject& owner, std::string_view name, MaybeIndex view, ViewUse use) {
    if (!view) return;
    ViewUse& is = views_[*view].use;
    if (is != ViewUse::none && is != use)
      owner.fault(FaultKind::conflict, name,
                  Value("view " + std::to_string(*view) + ", which holds " +
                        std::string(use_words[static_cast<std::size_t>(is)])),
                  "a view of its own for " + std::string(use_words[static_cast<std::size_t>(use)]));
    is = use;
  }

  std::vector<View> views_;
  std::vector<MaybeIndex> accessors_;
};

void take_attributes(ViewUses& uses, const GltfObject& attributes) {
  attributes.for_each_member(
      [&](std::string_view name, const Value&) { uses.take(attributes, name, ViewUse::vertices); });
}

void take_primitive(ViewUses& uses, const GltfObject& primitive) {
  primitive.with("attributes",
                 [&](const GltfObject& attributes) { take_attributes(uses, attributes); });
  uses.take(primitive, "indices", ViewUse::indices);
  primitive.for_each("targets",
                     [&](const GltfObject& target, std::size_t) { take_attributes(uses, target); });
}

void take_animation(ViewUses& uses, const GltfObject& animation) {
  animation.for_each("samplers", [&](const GltfObject& sampler, std::size_t) {
    for (const auto name : {"input", "output"}) uses.take(sampler, name, ViewUse::other);
  });
}

}  // namespace

void check_uses(const GltfObject& root) {
  ViewUses uses(root);
  root.for_each("animations",
                [&](const GltfObject& animation, std::size_t) { take_animation(uses, animation); });
  root.for_each("images", [&](const GltfObject& image, std::size_t) {
    uses.take_view(image, ViewUse::other);
  });
  root.for_each("meshes", [&](const GltfObject& mesh, std::size_t) {
    mesh.for_each("primitives", [&](const GltfObject& primitive, std::size_t) {
      take_primitive(uses, primitive);
    });
  });
  root.for_each("skins", [&](const GltfObject& skin, std::size_t) {
    uses.take(skin, "inverseBindMatrices", ViewUse::other);
  });
}

}  // namespace tia::gltf
