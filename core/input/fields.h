// How a kind describes its fields, once. Each described type has
//   template <class Visitor> static void fields(Visitor&& visit) {
//     visit("radius", &Sphere::radius, Spec{.about = "the radius", .min = 0, .open_min = true});
//   }
// Reader, range checks, canonical text, JSON Schema, request parameters, options and documents all
// walk that one description. A field's default is what a default-constructed object holds.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace tia {

/// Spec: what a field means and allows. Colour and vector fields apply the range to each component.
struct Spec {
  const char* about = "";
  const char* unit = "";  ///< "" = scene units, radians or none
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool open_min = false;  ///< min itself is not allowed
  bool required = false;
  bool not_zero = false;      ///< 0 itself is not allowed
  std::size_t min_items = 0;  ///< the fewest elements of a list
  std::size_t max_bytes = std::numeric_limits<std::size_t>::max();  ///< the longest text
};

/// Color: linear RGB, each >= 0. In JSON three numbers, or one number for a grey.
struct Color {
  double r = 0, g = 0, b = 0;
  bool operator==(const Color&) const = default;
};

/// The names of an enumeration's values, in the order of the values: specialise with
/// `static constexpr std::array names{…}`.
template <class E>
struct Names;
template <class E>
concept Named = requires {
  Names<E>::names;
};
template <Named E>
std::string_view name_of(E value) {
  return Names<E>::names[static_cast<std::size_t>(value)];
}

/// What a field means, with its unit: "the width, in pixels".
std::string about_text(const Spec& spec);
/// The words for a numeric range: "an integer from 1 to 64", "a number above 0".
std::string range_text(const Spec& spec, bool integer);
/// Whether a number lies in the field's range. NaN never does.
bool in_range(double number, const Spec& spec);

namespace detail {
struct AnyVisitor {
  template <class Owner, class Member>
  void operator()(std::string_view, Member Owner::*, const Spec&) {}
  template <class Owner, class Variant>
  void one_of(Variant Owner::*, const Spec&) {}
};
}  // namespace detail

/// Described: a struct whose JSON form is an object of the fields that it names.
template <class T>
concept Described = requires(detail::AnyVisitor visit) {
  T::fields(visit);
};

}  // namespace tia
