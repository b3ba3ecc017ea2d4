// What is asked of a map of radio waves, and its cells.
#pragma once

#include <array>
#include <optional>

#include "core/math/aabb.h"
#include "core/radio/radio_question.h"

namespace tia {

/// MapQuantity: what a cell tells. Their units stand in radio_map.cpp, in the same order.
enum class MapQuantity { gain, power, delay_spread, best_server, sinr };
template <>
struct Names<MapQuantity> {
  static constexpr std::array<std::string_view, 5> names{"gain", "power", "delay_spread",
                                                         "best_server", "sinr"};
};
enum class MapCombine { incoherent, coherent };
template <>
struct Names<MapCombine> {
  static constexpr std::array<std::string_view, 2> names{"incoherent", "coherent"};
};

/// Visitor: hands on what /radio/paths is asked of but its receivers, in whose place cells are.
template <class Visitor>
struct SenderFields {
  Visitor& visit;
  template <class Base, class Member>
  void operator()(std::string_view name, Member Base::*member, Spec spec) const {
    if (name == "receivers" || name == "channel") return;
    if (name == "transmitters") {
      spec.required = false;
      spec.min_items = 0;
      spec.about = "what sends, at most 1024; or tx";
    }
    visit(name, member, spec);
  }
};

/// MapGrid: cells in a plane. Cell (i, j) has its centre at origin + (i + 1/2) across + (j + 1/2)
/// down. Space/units: scene units, scene space.
struct MapGrid {
  Vec3d origin{}, across{}, down{};  ///< a cell's sides
  double cell = 1;                   ///< how long they are
  int width = 0, height = 0;

  Vec3d at(double column, double row) const { return origin + across * column + down * row; }
  Vec3d center(int column, int row) const { return at(column + 0.5, row + 0.5); }
  std::int64_t cells() const { return std::int64_t{width} * height; }
};

struct RadioMapQuestion : RadioQuestion {
  static constexpr std::string_view schema_name = "radio_map_question";
  static constexpr double usual_height = 1.5, thermal_dbm = -174;  // of a hertz, at 290 K
  std::vector<Vec3d> tx;
  std::optional<std::array<double, 4>> area;
  std::optional<double> cell, height;
  std::optional<Vec3d> origin, u, v;
  MapQuantity quantity = MapQuantity::gain;
  MapCombine combine = MapCombine::incoherent;
  std::optional<double> noise_dbm;
  double bandwidth_hz = 20e6;

  template <class Visitor>
  static void fields(Visitor&& visit);
  /// Besides too many antennas: none, or both ways to tell them; an area or plane of no size.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const RadioMapQuestion&) const = default;

  /// All that send: `transmitters`, or those of `tx`.
  std::vector<Antenna> senders() const;
  /// Where sender i's position stands in the question.
  std::string pointer_to(std::size_t sender) const;
  /// The cells. `bounds`: of the scene, where no area is told. Errors: InputError where that has no
  /// bounds, or the map more than `most` cells.
  MapGrid grid(const Aabb& bounds, std::int64_t most) const;
};

template <class Visitor>
void RadioMapQuestion::fields(Visitor&& visit) {
  using Q = RadioMapQuestion;
  constexpr double far = 1e9;
  RadioQuestion::fields(SenderFields<std::remove_reference_t<Visitor>>{visit});
  visit("tx", &Q::tx,
        Spec{.about = "where transmitters are that are as usual: isotropic, V, 0 dBm; in a query "
                      "once for each",
             .min = -far,
             .max = far});
  visit("area", &Q::area,
        Spec{.about = "x0,z0,x1,z1: the rectangle that the map shows, x to the right, z down, as "
                      "seen from above; else the scene's bounds",
             .min = -far,
             .max = far});
  visit("cell", &Q::cell,
        Spec{.about = "the side of a cell, whose centre is where waves are received; else a "
                      "hundredth of the longer side",
             .min = 0,
             .max = far,
             .open_min = true});
  visit("height", &Q::height,
        Spec{.about = "the plane y in which the area is; else 1.5", .min = -far, .max = far});
  visit("origin", &Q::origin,
        Spec{.about = "instead of area and height: the upper left corner of any other rectangle",
             .min = -far,
             .max = far});
  visit("u", &Q::u,
        Spec{.about = "from the origin to the upper right corner", .min = -far, .max = far});
  visit("v", &Q::v,
        Spec{.about = "from the origin to the lower left corner, at right angles to u",
             .min = -far,
             .max = far});
  visit(
      "quantity", &Q::quantity,
      Spec{.about = "what a cell tells: gain, of the transmitter that is received best there; "
                    "power, of all together; delay_spread, of the best one's paths; "
                    "best_server, its number; sinr, its power over that of all others and noise"});
  visit("combine", &Q::combine,
        Spec{.about = "how a transmitter's paths are added: by their powers, or as waves"});
  visit("noise_dbm", &Q::noise_dbm,
        Spec{.about = "of sinr; else -174 dBm of every hertz of bandwidth_hz",
             .unit = "dBm",
             .min = -300,
             .max = 200});
  visit("bandwidth_hz", &Q::bandwidth_hz,
        Spec{.about = "what noise is received in", .unit = "Hz", .min = 1, .max = 1e11});
}

}  // namespace tia
