#include "core/scene/backdrop.h"

namespace tia {

void Codec<Backdrop>::read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                           Backdrop& out) {
  if (const auto* word = v.as<std::string>()) {
    if (*word == Backdrop::transparent) out.color.reset();
    else detail::unknown_word(v, at, {Backdrop::transparent}, faults);
  } else if (v.as<double>() != nullptr || v.as<Value::Array>() != nullptr) {
    Color color;
    const std::size_t before = faults.count();
    read_value(v, at, spec, faults, color);
    if (faults.count() == before) out.color = color;
  } else {
    detail::wrong_type(v, at, allowed(spec), faults);
  }
}
Value Codec<Backdrop>::write(const Backdrop& v) {
  if (v.is_transparent()) return Backdrop::transparent;
  return write_value(*v.color);
}
Value Codec<Backdrop>::schema(const Spec& spec, Definitions& named) {
  const Value word = Value::Object{{"const", Backdrop::transparent}};
  return Value::Object{{"anyOf", Value::Array{schema_of<Color>(spec, named), word}}};
}
std::string Codec<Backdrop>::allowed(const Spec& spec) {
  return Codec<Color>::allowed(spec) + ", or \"transparent\"";
}

}  // namespace tia
