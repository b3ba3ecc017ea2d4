// THE LIST of textures. A new kind is one file beside this one and one entry here.
#pragma once

#include <concepts>
#include <string_view>
#include <variant>

#include "core/input/kinds.h"
#include "core/materials/checker.h"
#include "core/materials/gradient.h"
#include "core/materials/image_texture.h"
#include "core/materials/marble.h"
#include "core/materials/noise.h"
#include "core/materials/stripes.h"
#include "core/materials/wood.h"

namespace tia {

/// A form of a texture: color_at() tells its linear RGB, each >= 0, at the point p of a surface
/// whose coordinates there are uv; heap_bytes() what it owns on the heap, in bytes.
template <class F>
concept IsTextureForm = TellsHeap<F> &&
    requires(const F& form, const Vec3d& p, const Vec2d& uv, double blur) {
  { color_at(form, p, uv, blur) } -> std::same_as<Vec3d>;
};
/// What a kind must bring: prepare() makes a form of it.
template <class Kind>
concept IsTexture = IsKind<Kind> && requires(const Kind& kind) {
  { prepare(kind) } -> IsTextureForm;
};

/// TextureList: checks each kind of the list against IsTexture.
template <IsTexture Kind>
using ListedTexture = Kind;
template <class... Kinds>
using TextureList = std::variant<ListedTexture<Kinds>...>;

/// Texture: the linear RGB of a surface as a function of the point.
struct Texture {
  static constexpr std::string_view schema_name = "texture";
  using Kinds = TextureList<Checker, Stripes, Gradient, Noise, Marble, Wood, ImageTexture>;
  Kinds kind;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit.one_of(&Texture::kind, Spec{.about = "the kind of texture", .required = true});
  }
  bool operator==(const Texture&) const = default;
};

/// TextureForm: a texture of any kind, prepared for lookups.
struct TextureForm {
  FormsOf<Texture::Kinds> kind;
};

/// Domain: a texture that was read without a fault.
inline TextureForm prepare(const Texture& texture) {
  return std::visit([](const auto& kind) { return TextureForm{prepare(kind)}; }, texture.kind);
}

/// Returns: linear RGB, each >= 0, at the point p of a surface whose coordinates there are uv.
/// Space/units: scene units, the space of the object that has the texture.
/// Domain: blur >= 0: how far p may be off its surface. A point less than that below the edge of a
/// cell counts as beyond the edge, because a surface along the edge would show speckles otherwise.
inline Vec3d color_at(const TextureForm& texture, const Vec3d& p, const Vec2d& uv, double blur) {
  return std::visit([&](const auto& kind) { return color_at(kind, p, uv, blur); }, texture.kind);
}

}  // namespace tia
