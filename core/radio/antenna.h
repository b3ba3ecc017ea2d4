// Antennas: where they are, what they send in which direction, and how it is polarised.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/input/codec.h"
#include "core/math/vec3.h"

namespace tia {

/// THE LIST of patterns; what each sends is in antenna.cpp, in the same order.
enum class AntennaPattern { isotropic, dipole, patch };
template <>
struct Names<AntennaPattern> {
  static constexpr std::array<std::string_view, 3> names{"isotropic", "dipole", "patch"};
};

/// THE LIST of polarisations; the ports of each are in antenna.cpp, in the same order.
enum class Polarization { vertical, horizontal, cross, slant };
template <>
struct Names<Polarization> {
  static constexpr std::array<std::string_view, 4> names{"V", "H", "cross", "slant"};
};

/// Antenna: a transmitter or a receiver. Space/units: scene units, scene space; its own frame is
/// x' = x, y' = -z, z' = y, then turned; theta from z', phi from x' towards y'.
struct Antenna {
  static constexpr std::string_view schema_name = "antenna";
  std::string name{};
  Vec3d position{}, orientation_degrees{};
  AntennaPattern pattern = AntennaPattern::isotropic;
  Polarization polarization = Polarization::vertical;
  double power_dbm = 0;
  Vec3d velocity{};  ///< metres a second

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("name", &Antenna::name,
          Spec{.about = "what the answer calls it; else its number", .max_bytes = 256});
    visit("position", &Antenna::position,
          Spec{.about = "where it is", .min = -1e9, .max = 1e9, .required = true});
    visit("orientation_degrees", &Antenna::orientation_degrees,
          Spec{.about = "how it is turned: about x, then y, then z, as rotate_degrees; unturned "
                        "its axis is y, and a patch looks along x",
               .unit = "degrees",
               .min = -1e6,
               .max = 1e6});
    visit("pattern", &Antenna::pattern,
          Spec{.about = "how its gain depends on the direction: isotropic 1; dipole a half wave's, "
                        "1.643 (cos(pi/2 cos theta)/sin theta)^2; patch 3GPP TR 38.901's, table "
                        "7.3-1"});
    visit(
        "polarization", &Antenna::polarization,
        Spec{.about = "its ports: V one along theta-hat; H one along phi-hat; cross these two; "
                      "slant two, (theta-hat + phi-hat)/sqrt 2 and (theta-hat - phi-hat)/sqrt 2"});
    visit("power_dbm", &Antenna::power_dbm,
          Spec{.about = "what a transmitter sends, which gains do not count",
               .unit = "dBm",
               .min = -200,
               .max = 200});
    visit("velocity", &Antenna::velocity,
          Spec{.about = "how it moves, for the Doppler shift",
               .unit = "metres a second",
               .min = -1e6,
               .max = 1e6});
  }
  bool operator==(const Antenna&) const = default;
};

/// AntennaPorts: by port the field that it sends in a direction, whose square is the gain; by
/// reciprocity also what it takes of a field that comes from there. Space/units: scene space.
struct AntennaPorts {
  int count = 1;
  std::array<Vec3d, 2> field{};
};
/// Domain: `away` is unit and leads away from the antenna.
AntennaPorts ports_of(const Antenna& antenna, const Vec3d& away);
int port_count(Polarization polarization);

/// The gain of a pattern in a direction of the antenna's own frame, as a power.
/// Domain: unit. Source: dipole: Balanis, "Antenna Theory", 4th ed. (2016), (4-84), (4-91); patch:
/// 3GPP TR 38.901 V17 (2022), table 7.3-1.
double gain_of(AntennaPattern pattern, const Vec3d& own);

}  // namespace tia
