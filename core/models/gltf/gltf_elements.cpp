#include "core/models/gltf/gltf_elements.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/input/json.h"
#include "core/models/gltf/gltf_words.h"

namespace tia::gltf {
namespace {

template <class Number, bool normalized, class C>
Number number_of(C component) {
  if constexpr (normalized && std::is_integral_v<C>) {
    constexpr Number most = Number(std::numeric_limits<C>::max());
    return std::max(Number(component) / most, Number(-1));
  } else {
    return static_cast<Number>(component);
  }
}

// Where elements lie: `count` of them, `stride` bytes from one to the next.
struct ElementBytes {
  const std::uint8_t* from;
  std::size_t stride, count;
};

template <class Number, class C, bool normalized>
void copy_as(const ElementBytes& bytes, const ElementLayout& layout, Number* to) {
  if (layout.columns == 1 && bytes.stride == layout.rows * sizeof(C)) {
    const std::size_t all = bytes.count * layout.rows;  // nothing lies between
    for (std::size_t i = 0; i < all; ++i)
      to[i] = number_of<Number, normalized>(load<C>(bytes.from + i * sizeof(C)));
    return;
  }
  for (std::size_t i = 0; i < bytes.count; ++i)
    for (std::size_t column = 0; column < layout.columns; ++column) {
      const std::uint8_t* from = bytes.from + i * bytes.stride + column * layout.column_stride();
      for (std::size_t row = 0; row < layout.rows; ++row)
        *to++ = number_of<Number, normalized>(load<C>(from + row * sizeof(C)));
    }
}

template <class Number, class C>
void copy_as(const ElementBytes& bytes, const ElementLayout& layout, Number* to) {
  if constexpr (std::is_floating_point_v<Number>)
    if (layout.normalized) return copy_as<Number, C, true>(bytes, layout, to);
  copy_as<Number, C, false>(bytes, layout, to);
}

template <class Number>
void copy(const ElementBytes& bytes, const ElementLayout& layout, Number* to) {
  switch (layout.component) {
    case Component::signed_byte: return copy_as<Number, std::int8_t>(bytes, layout, to);
    case Component::unsigned_byte: return copy_as<Number, std::uint8_t>(bytes, layout, to);
    case Component::signed_short: return copy_as<Number, std::int16_t>(bytes, layout, to);
    case Component::unsigned_short: return copy_as<Number, std::uint16_t>(bytes, layout, to);
    case Component::unsigned_int: return copy_as<Number, std::uint32_t>(bytes, layout, to);
    case Component::floating:
      if constexpr (std::is_floating_point_v<Number>)
        return copy_as<Number, float>(bytes, layout, to);
  }
}

std::string pointer_to(const Accessor& accessor) {
  return "/accessors/" + std::to_string(accessor.index);
}

std::uint32_t sparse_index(const SparseElements& sparse, std::size_t i) {
  switch (sparse.component) {
    case Component::unsigned_byte: return sparse.indices[i];
    case Component::unsigned_short: return load<std::uint16_t>(sparse.indices.data() + i * 2);
    default: return load<std::uint32_t>(sparse.indices.data() + i * 4);
  }
}

// Puts the elements in their places, those before `count`.
template <class Number>
bool overlay(const GltfSource& source, const Accessor& accessor, std::uint64_t count, Number* to) {
  const SparseElements& sparse = *accessor.sparse;
  const std::size_t stride = accessor.layout.stride(), numbers = accessor.layout.numbers();
  std::uint64_t least = 0;
  for (std::size_t i = 0; i < sparse.count; ++i) {
    const std::uint64_t index = sparse_index(sparse, i);
    if (index < least || index >= accessor.count) {
      source.faults.add({FaultKind::out_of_range, pointer_to(accessor) + "/sparse",
                         Value(static_cast<double>(index)),
                         "indices that ascend, below " + std::to_string(accessor.count) +
                             ", which number " + std::to_string(i) + " does not"});
      return false;
    }
    if (index >= count) return true;
    copy(ElementBytes{sparse.values.data() + i * stride, stride, 1}, accessor.layout,
         to + index * numbers);
    least = index + 1;
  }
  return true;
}

// A sum of what is 0 for each good number is cheap to ask for.
template <class Number>
bool all_within(const std::vector<Number>& numbers, Number most) {
  std::size_t wrong = 0;
  for (const Number number : numbers) wrong += std::fabs(number) <= most ? 0 : 1;
  return wrong == 0;
}

template <class Number>
bool check(const GltfSource& source, const Accessor& accessor, const std::vector<Number>& numbers,
           double most) {
  const Number limit = most > static_cast<double>(std::numeric_limits<Number>::max())
                           ? std::numeric_limits<Number>::max()
                           : static_cast<Number>(most);
  if (all_within(numbers, limit)) return true;
  std::size_t at = 0;
  while (std::fabs(numbers[at]) <= limit) ++at;
  const auto got = static_cast<double>(numbers[at]);
  const std::size_t size = accessor.layout.numbers();
  const bool finite = std::fabs(got) <= std::numeric_limits<double>::max();
  source.faults.add({FaultKind::out_of_range, pointer_to(accessor),
                     finite ? Value(got)
                            : Value(got != got ? "NaN"
                                    : got > 0  ? "Infinity"
                                               : "-Infinity"),
                     (most > 1e300 ? "finite numbers" : "numbers of up to " + number_text(most)) +
                         std::string(", which component ") + std::to_string(at % size) +
                         " of element " + std::to_string(at / size) + " is not"});
  return false;
}

}  // namespace

template <class Number>
std::optional<std::vector<Number>> read_elements(const GltfSource& source, const Accessor& accessor,
                                                 std::uint64_t count, double most) {
  std::vector<Number> numbers(count * accessor.layout.numbers());
  if (!accessor.bytes.empty())
    copy(ElementBytes{accessor.bytes.data(), accessor.stride, count}, accessor.layout,
         numbers.data());
  if (accessor.sparse && !overlay(source, accessor, count, numbers.data())) return std::nullopt;
  if constexpr (std::is_floating_point_v<Number>)
    if (accessor.layout.component == Component::floating && !check(source, accessor, numbers, most))
      return std::nullopt;
  return numbers;
}

template std::optional<std::vector<float>> read_elements(const GltfSource&, const Accessor&,
                                                         std::uint64_t, double);
template std::optional<std::vector<double>> read_elements(const GltfSource&, const Accessor&,
                                                          std::uint64_t, double);
template std::optional<std::vector<std::uint32_t>> read_elements(const GltfSource&, const Accessor&,
                                                                 std::uint64_t, double);

}  // namespace tia::gltf
