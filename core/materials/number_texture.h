// NumberTexture: what gives a number of a material its value at each point, as pbrt's FloatTexture.
#pragma once

#include "core/input/boxed.h"
#include "core/materials/texture.h"

namespace tia {

/// Channel: the component of a texture's colour that counts.
enum class Channel { r, g, b };
template <>
struct Names<Channel> {
  static constexpr std::array<std::string_view, 3> names{"r", "g", "b"};
};

/// OfNumbers: a kind of texture where it stands for numbers. Its colours are 1 at most, and the
/// codes of a picture are proportional to its numbers where nothing else is said.
template <IsTexture Kind>
struct OfNumbers : Kind {
  OfNumbers() {
    if constexpr (requires { &Kind::transfer; }) this->transfer = Encoding::linear;
  }
  template <class Visitor>
  static void fields(Visitor&& visit) {
    Kind::fields([&](std::string_view name, auto member, Spec spec) {
      if (name == "colors") spec.max = 1;
      visit(name, member, spec);
    });
  }
  bool operator==(const OfNumbers&) const = default;
};

namespace detail {

template <class List>
struct KindsOfNumbers;
template <class... Kinds>
struct KindsOfNumbers<std::variant<Kinds...>> {
  using List = TextureList<OfNumbers<Kinds>...>;
};

}  // namespace detail

/// NumberTexture: a texture of any kind, and which numbers its colours mean.
struct NumberTexture {
  static constexpr std::string_view schema_name = "number_texture";
  using Kinds = detail::KindsOfNumbers<Texture::Kinds>::List;
  Kinds kind;
  std::array<double, 2> range{0, 1};
  Channel channel = Channel::r;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit.one_of(&NumberTexture::kind, Spec{.about = "the kind of texture", .required = true});
    visit("range", &NumberTexture::range,
          Spec{.about = "the numbers where it is black and where it is white",
               .min = 0,
               .max = 1,
               .required = true});
    visit("channel", &NumberTexture::channel,
          Spec{.about = "the component of its colours that counts"});
  }
  bool operator==(const NumberTexture&) const = default;
};
extern template struct FieldsCodec<NumberTexture>;

/// NumberTextureForm: a texture of numbers, prepared for lookups.
struct NumberTextureForm {
  TextureForm texture;
  std::array<double, 2> range{0, 1};
  Channel channel = Channel::r;
};
/// Domain: a texture that was read without a fault.
NumberTextureForm prepare(const NumberTexture& texture);

/// Returns: a number within the range, its ends exactly where the colour is black or white.
/// Space/units, Domain: as color_at's.
double number_at(const NumberTextureForm& form, const Vec3d& p, const Vec2d& uv, double blur);

/// NumberOrTexture: a number 0 .. 1 of a material, the same everywhere or textured. In JSON a
/// number or an object.
struct NumberOrTexture : std::variant<double, Boxed<NumberTexture>> {
  NumberOrTexture(double number = 0) : variant(number) {}
  NumberOrTexture(NumberTexture texture) : variant(Boxed<NumberTexture>(std::move(texture))) {}
  bool operator==(const NumberOrTexture&) const = default;
};
template <>
struct Codec<NumberOrTexture> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   NumberOrTexture& out);
  static Value write(const NumberOrTexture& v);
  static Value schema(const Spec& spec, Definitions& named);
  static std::string allowed(const Spec& spec);
};

}  // namespace tia
