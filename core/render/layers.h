// THE LIST of layers: what may be known of a picture's pixels besides, or instead of, their colour.
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string_view>

#include "core/scene/integrators.h"

namespace tia {

enum class Layer { rgba, normal, albedo, Z, object, direct, indirect, emission, variance, samples };

/// LayerRow: all there is to say of a layer but what it computes.
struct LayerRow {
  Layer layer;
  std::string_view text;   ///< its name
  std::string_view parts;  ///< a letter for each of its numbers; none where there is but one
  bool whole = false;      ///< whether they are whole numbers
  /// Whose picture it is, where it is another integrator's.
  std::optional<IntegratorName> feature = {};
  /// Whether it is a part of the light that a path gathers, or the spread of a pixel's samples.
  bool of_paths = false, of_samples = false;

  /// Whether it comes of the samples of the picture itself, and is not its light.
  constexpr bool is_beside() const { return layer != Layer::rgba && !feature; }
  constexpr int planes() const { return parts.empty() ? 1 : static_cast<int>(parts.size()); }
};

inline constexpr std::array all_layers = std::to_array<LayerRow>({
    {.layer = Layer::rgba, .text = "rgba", .parts = "RGBA"},
    {.layer = Layer::normal, .text = "normal", .parts = "XYZ", .feature = IntegratorName::normal},
    {.layer = Layer::albedo, .text = "albedo", .parts = "RGB", .feature = IntegratorName::albedo},
    {.layer = Layer::Z, .text = "Z", .parts = "", .feature = IntegratorName::depth},
    {.layer = Layer::object,
     .text = "object",
     .parts = "",
     .whole = true,
     .feature = IntegratorName::object},
    {.layer = Layer::direct, .text = "direct", .parts = "RGB", .of_paths = true},
    {.layer = Layer::indirect, .text = "indirect", .parts = "RGB", .of_paths = true},
    {.layer = Layer::emission, .text = "emission", .parts = "RGB", .of_paths = true},
    {.layer = Layer::variance, .text = "variance", .parts = "RGB", .of_samples = true},
    {.layer = Layer::samples, .text = "samples", .parts = "", .whole = true},
});

constexpr const LayerRow& row_of(Layer layer) {
  return all_layers[static_cast<std::size_t>(layer)];
}
static_assert(
    [] {
      for (std::size_t i = 0; i < all_layers.size(); ++i)
        if (static_cast<std::size_t>(all_layers[i].layer) != i) return false;
      return true;
    }(),
    "the rows stand in the order of the layers, one a layer");

template <>
struct Names<Layer> {
  static constexpr auto names = [] {
    std::array<std::string_view, all_layers.size()> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = all_layers[i].text;
    return all;
  }();
};

/// LayerSet: some of them.
class LayerSet {
 public:
  constexpr LayerSet() = default;
  constexpr LayerSet(std::initializer_list<Layer> some) {
    for (const Layer each : some) add(each);
  }
  constexpr void add(Layer layer) { bits_ |= bit(layer); }
  constexpr bool has(Layer layer) const { return (bits_ & bit(layer)) != 0; }
  /// Calls f(row) for each, in the order of the list.
  template <class F>
  constexpr void for_each(const F& f) const {
    for (const LayerRow& row : all_layers)
      if (has(row.layer)) f(row);
  }
  template <class F>
  constexpr bool any(const F& f) const {
    bool found = false;
    for_each([&](const LayerRow& row) { found = found || f(row); });
    return found;
  }
  constexpr int planes() const {
    int count = 0;
    for_each([&](const LayerRow& row) { count += row.planes(); });
    return count;
  }
  constexpr unsigned bits() const { return bits_; }
  constexpr bool operator==(const LayerSet&) const = default;

 private:
  static constexpr unsigned bit(Layer layer) { return 1U << static_cast<unsigned>(layer); }
  unsigned bits_ = 0;
};

}  // namespace tia
