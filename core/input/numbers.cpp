#include "core/input/numbers.h"

#include <bit>
#include <cmath>

#include "core/input/base64.h"

namespace tia {
namespace {

template <class T>
constexpr std::string_view key = std::is_floating_point_v<T> ? "float32" : "uint32";

// Base64 of whole 4-byte numbers: 16 digits are three of them; then one (the sixth digit has two
// bits left), two (the eleventh four) or none.
constexpr std::string_view words_pattern =
    "^([A-Za-z0-9+/]{16})*([A-Za-z0-9+/]{5}[AQgw]==|[A-Za-z0-9+/]{10}[AEIMQUYcgkosw048]=)?$";

template <class T>
std::string base64_text() {
  return "the bytes of " + std::string(key<T>) + " numbers, little-endian, in base64 (RFC 4648)";
}

std::string in_words(double number) {
  if (std::isnan(number)) return "NaN";
  if (std::isinf(number)) return number > 0 ? "Infinity" : "-Infinity";
  return number_text(number);
}

template <class T>
T number_at(const std::uint8_t* byte) {
  std::uint32_t bits = 0;
  for (int i = 3; i >= 0; --i) bits = bits << 8U | byte[i];
  return std::bit_cast<T>(bits);
}

using Bytes = std::vector<std::uint8_t>;

// The bytes of whole numbers, or a fault and nothing.
template <class T>
Bytes read_bytes(const Value& v, const Place& at, Faults& faults) {
  Bytes bytes;
  const auto* text = v.as<std::string>();
  if (text == nullptr) {
    detail::wrong_type(v, at, base64_text<T>(), faults);
  } else if (const auto wrong = decode_base64(*text, bytes)) {
    constexpr std::size_t shown = 16;
    detail::wrong_type(
        Value(text->substr(*wrong, shown)), at,
        base64_text<T>() + "; it is not from its character " + std::to_string(*wrong) + " on",
        faults);
  } else if (bytes.size() % sizeof(T) != 0) {
    detail::wrong_type(Value(std::to_string(bytes.size()) + " bytes"), at,
                       base64_text<T>() + ", 4 bytes each", faults);
  } else {
    return bytes;
  }
  return {};
}

// As read_number does, but a number in bytes has no place of its own: the fault says its index.
template <class T>
void read_base64(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                 std::vector<typename Numbers<T>::Number>& out) {
  const std::size_t before = faults.count();
  const Bytes bytes = read_bytes<T>(v, at, faults);
  if (faults.count() != before) return;
  if (bytes.size() / sizeof(T) < spec.min_items)
    return detail::wrong_type(Value(std::to_string(bytes.size()) + " bytes"), at,
                              detail::array_text(spec) + " numbers of 4 bytes", faults);
  out.reserve(bytes.size() / sizeof(T));
  for (std::size_t i = 0; i < bytes.size() && !faults.full(); i += sizeof(T)) {
    const T number = number_at<T>(&bytes[i]);
    const auto exact = static_cast<double>(number);
    if (!in_range(exact, spec) || !std::isfinite(exact))
      faults.add({FaultKind::out_of_range, at.pointer(),
                  Value(in_words(exact) + " at index " + std::to_string(i / sizeof(T))),
                  "bytes of numbers, each " + Codec<typename Numbers<T>::Number>::allowed(spec)});
    out.push_back(number + typename Numbers<T>::Number{});  // -0 becomes 0
  }
}

template <class T>
void read_typed_array(const Value::Object& object, const Place& at, const Spec& spec,
                      Faults& faults, std::vector<typename Numbers<T>::Number>& out) {
  detail::MemberReader from{object, at, faults};
  if (const Value* text = from.member(key<T>))
    read_base64<T>(*text, at.at(key<T>), spec, faults, out);
  else from.add_missing(key<T>, Spec{.about = "the numbers"}, base64_text<T>());
  from.finish();
}

}  // namespace

template <class T>
void Codec<Numbers<T>>::read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                             Numbers<T>& out) {
  using Number = typename Numbers<T>::Number;
  const auto* object = v.as<Value::Object>();
  if (object == nullptr && v.as<Value::Array>() == nullptr)
    return detail::wrong_type(v, at, allowed(spec), faults);
  const std::size_t before = faults.count();
  std::vector<Number> values;
  if (object != nullptr) {
    read_typed_array<T>(*object, at, spec, faults, values);
  } else if (const auto* list = detail::read_array(v, at, spec, faults)) {
    values.resize(list->size());
    for (std::size_t i = 0; i < list->size() && !faults.full(); ++i)
      read_value((*list)[i], at.at(i), spec, faults, values[i]);
  }
  if (faults.count() == before) out.values = std::move(values);
}

template <class T>
Value Codec<Numbers<T>>::write(const Numbers<T>& v) {
  Value::Array list;
  list.reserve(v.values.size());
  for (const auto number : v.values) list.emplace_back(static_cast<double>(number));
  return list;
}

template <class T>
Value Codec<Numbers<T>>::schema(const Spec& spec, Definitions& named) {
  using List = std::vector<typename Numbers<T>::Number>;
  const Value text = Value::Object{{"type", "string"},
                                   {"contentEncoding", "base64"},
                                   {"pattern", words_pattern},
                                   {"examples", Value::Array{"", "AAAAAA==", "AAAAAAEAAAACAAAA"}}};
  const Value typed = Value::Object{{"type", "object"},
                                    {"properties", Value::Object{{std::string(key<T>), text}}},
                                    {"required", Value::Array{key<T>}},
                                    {"additionalProperties", false}};
  return Value::Object{{"oneOf", Value::Array{schema_of<List>(spec, named), typed}}};
}

template <class T>
std::string Codec<Numbers<T>>::allowed(const Spec& spec) {
  return detail::array_text(spec) + " of numbers, each " +
         Codec<typename Numbers<T>::Number>::allowed(spec) + ", or {\"" + std::string(key<T>) +
         "\": \"base64\"}";
}

template struct Codec<Numbers<float>>;
template struct Codec<Numbers<std::uint32_t>>;

}  // namespace tia
