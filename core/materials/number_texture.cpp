#include "core/materials/number_texture.h"

namespace tia {

template struct FieldsCodec<NumberTexture>;

NumberTextureForm prepare(const NumberTexture& texture) {
  return std::visit(
      [&](const auto& kind) {
        return NumberTextureForm{{prepare(kind)}, texture.range, texture.channel};
      },
      texture.kind);
}

double number_at(const NumberTextureForm& form, const Vec3d& p, const Vec2d& uv, double blur) {
  const Vec3d color = color_at(form.texture, p, uv, blur);
  const double channels[] = {color.x, color.y, color.z};
  const double share = channels[static_cast<std::size_t>(form.channel)];
  const auto& [black, white] = form.range;
  return share < 1 ? black + (white - black) * share : white;
}

void Codec<NumberOrTexture>::read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                                  NumberOrTexture& out) {
  if (v.as<Value::Object>() != nullptr)
    return read_value(v, at, spec, faults, out.emplace<Boxed<NumberTexture>>());
  if (v.as<double>() == nullptr) return detail::wrong_type(v, at, allowed(spec), faults);
  read_value(v, at, spec, faults, out.emplace<double>());
}
Value Codec<NumberOrTexture>::write(const NumberOrTexture& v) {
  if (const auto* number = std::get_if<double>(&v)) return *number;
  return write_value(std::get<Boxed<NumberTexture>>(v));
}
Value Codec<NumberOrTexture>::schema(const Spec& spec, Definitions& named) {
  return Value::Object{{"anyOf", Value::Array{schema_of<double>(spec, named),
                                              schema_of<NumberTexture>(spec, named)}}};
}
std::string Codec<NumberOrTexture>::allowed(const Spec& spec) {
  return Codec<double>::allowed(spec) + ", or a texture with a range";
}

}  // namespace tia
