// RadioMaterial: what a body is to radio waves. Light does not see it.
#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "core/input/fields.h"
#include "core/input/kinds.h"
#include "core/materials/itu_materials.h"

namespace tia {

/// What those materials have in common that waves may go through. Sheets are open surfaces, and
/// planes of a given thickness; closed bodies are as thick as they are.
template <class Kind, class Visitor>
void radio_body_fields(Visitor&& visit) {
  visit("thickness", &Kind::thickness,
        Spec{.about = "how thick a sheet is, which an open surface is, and a plane for which this "
                      "is given; else an open surface is 0.1 m thick, and a plane a half space",
             .unit = "metres",
             .min = 0,
             .max = 100,
             .open_min = true});
  visit("through", &Kind::through,
        Spec{.about = "whether waves go through closed bodies, too, as they do through sheets"});
}

/// ItuRadio: a building material by its name.
struct ItuRadio {
  static constexpr std::string_view type = "itu";
  ItuMaterial name{};
  std::optional<double> thickness{};
  bool through = false;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("name", &ItuRadio::name,
          Spec{.about = "a material of Recommendation ITU-R P.2040-3, table 3", .required = true});
    radio_body_fields<ItuRadio>(visit);
  }
  bool operator==(const ItuRadio&) const = default;
};

/// DielectricRadio: one by its numbers, the same at every frequency.
struct DielectricRadio {
  static constexpr std::string_view type = "dielectric";
  double relative_permittivity = 1, conductivity = 0;
  std::optional<double> thickness{};
  bool through = false;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("relative_permittivity", &DielectricRadio::relative_permittivity,
          Spec{.about = "the real part of what multiplies the permittivity of empty space",
               .min = 1,
               .max = 1e4,
               .required = true});
    visit("conductivity", &DielectricRadio::conductivity,
          Spec{.about = "what makes it lossy", .unit = "siemens a metre", .min = 0, .max = 1e9});
    radio_body_fields<DielectricRadio>(visit);
  }
  bool operator==(const DielectricRadio&) const = default;
};

/// ConductorRadio: a perfect one: all is reflected, nothing goes through.
struct ConductorRadio {
  static constexpr std::string_view type = "conductor";
  template <class Visitor>
  static void fields(Visitor&&) {}
  bool operator==(const ConductorRadio&) const = default;
};

/// AirRadio: as if nothing were there.
struct AirRadio {
  static constexpr std::string_view type = "air";
  template <class Visitor>
  static void fields(Visitor&&) {}
  bool operator==(const AirRadio&) const = default;
};

struct RadioMaterial {
  static constexpr std::string_view schema_name = "radio_material";
  std::variant<ItuRadio, DielectricRadio, ConductorRadio, AirRadio> kind;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit.one_of(&RadioMaterial::kind,
                 Spec{.about = "what it is to radio waves", .required = true});
  }
  bool operator==(const RadioMaterial&) const = default;
};

}  // namespace tia
