// THE LIST of materials. A new kind is one file beside this one and one entry here.
#pragma once

#include <string_view>
#include <variant>

#include "core/materials/finish.h"

namespace tia {

struct Material {
  static constexpr std::string_view schema_name = "material";
  std::variant<Finish> kind;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit.one_of(&Material::kind, Spec{.about = "the kind of material"});
  }
  bool operator==(const Material&) const = default;
};

}  // namespace tia
