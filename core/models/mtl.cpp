#include "core/models/mtl.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "core/models/mtl_maps.h"
#include "core/models/mtl_material.h"
#include "core/models/mtl_reading.h"

namespace tia {
namespace {

constexpr double mtl_unbounded = std::numeric_limits<double>::max();

/// MtlNumber: a statement of one number.
struct MtlNumber {
  std::string_view name;
  double least, most;
  std::optional<double> MtlMaterial::*value;
};
constexpr std::array<MtlNumber, 8> mtl_numbers{{
    {"ns", 0, mtl_unbounded, &MtlMaterial::exponent},
    {"d", 0, 1, &MtlMaterial::dissolve},
    {"tr", 0, 1, &MtlMaterial::transparency},
    {"pr", 0, 1, &MtlMaterial::roughness},
    {"pm", 0, 1, &MtlMaterial::metallic},
    {"ps", 0, 1, &MtlMaterial::sheen},
    {"pc", 0, 1, &MtlMaterial::clearcoat},
    {"pcr", 0, 1, &MtlMaterial::clearcoat_roughness},
}};

/// MtlColor: a statement of one number or three.
struct MtlColor {
  std::string_view name;
  double most;
  std::optional<Color> MtlMaterial::*value;
};
constexpr std::array<MtlColor, 2> mtl_colors{{
    {"kd", 1, &MtlMaterial::diffuse},
    {"ke", mtl_unbounded, &MtlMaterial::emission},
}};

/// MtlMap: a statement that names a picture.
struct MtlMap {
  std::string_view name;
  MaybeTexture MtlMaterial::*value;
};
constexpr std::array<MtlMap, 6> mtl_maps{{
    {"map_kd", &MtlMaterial::diffuse_map},
    {"map_ke", &MtlMaterial::emission_map},
    {"map_d", &MtlMaterial::dissolve_map},
    {"map_pr", &MtlMaterial::roughness_map},
    {"map_pm", &MtlMaterial::metallic_map},
    {"norm", &MtlMaterial::normal_map},
}};

// Without a counterpart here, and of no use to those who want the material.
constexpr std::array<std::string_view, 4> mtl_passed_over{"ka", "ks", "tf", "map_ka"};

template <class Rows>
const auto* mtl_row(const Rows& rows, std::string_view name) {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.name == name; });
  return found == rows.end() ? nullptr : &*found;
}

std::string small_mtl_letters(std::string_view word) {
  std::string small(word);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

/// MtlReader: goes through the lines.
class MtlReader {
 public:
  explicit MtlReader(MtlReading& reading) : reading_(reading), maps_(reading) {}

  void read() {
    while (reading_.next()) statement(ObjWords(reading_.line()));
    finish();
  }

 private:
  void statement(ObjWords words) {
    const std::string_view word = words.take();
    if (word.empty()) return;
    const std::string name = small_mtl_letters(word);
    if (name == "newmtl") return begin(words.rest());
    if (!material_)
      return reading_.warn_once("", "statements before the first newmtl are not taken");
    if (const MtlNumber* row = mtl_row(mtl_numbers, name)) return number(*row, words);
    if (const MtlColor* row = mtl_row(mtl_colors, name)) return color(*row, words);
    if (name == "ni") return ior(words);
    if (name == "illum") return illumination(words);
    if (const MtlMap* row = mtl_row(mtl_maps, name)) {
      if (const MaybeTexture use = maps_.read(row->name, words)) *material_.*row->value = use;
      return;
    }
    if (std::find(mtl_passed_over.begin(), mtl_passed_over.end(), name) == mtl_passed_over.end())
      skip(word);
  }
  void skip(std::string_view word) {
    const std::string name = excerpt_of(word, 64);
    reading_.warn_once(name, name + ": statements of this kind are not taken");
  }
  void begin(std::string_view name) {
    finish();
    if (reading_.model().materials.size() >= most_mtl_materials)
      return reading_.stop(name, most_mtl_materials, "materials");
    material_.emplace().name = name;
  }
  void finish() {
    if (material_) reading_.model().materials.push_back(mtl_material_of(*material_));
    material_.reset();
  }

  // ---- numbers --------------------------------------------------------------------------------

  // A finite number; none, and a fault, where there is none.
  std::optional<double> take(ObjWords& words) {
    double number = 0;
    const ObjNumber got = words.take(number);
    if (got == ObjNumber::taken) return number;
    reading_.fault(got == ObjNumber::too_large ? FaultKind::out_of_range : FaultKind::malformed,
                   reading_.line(), "finite numbers after the statement's name");
    return std::nullopt;
  }
  // One number, and nothing after it.
  std::optional<double> take_last(ObjWords& words) {
    const std::optional<double> number = take(words);
    if (!number || words.empty()) return number;
    reading_.fault(FaultKind::malformed, reading_.line(), "one number");
    return std::nullopt;
  }
  double clamped(double number, double least, double most) {
    const double nearest = std::clamp(number, least, most);
    if (nearest != number)
      reading_.warn(excerpt_of(reading_.line(), 64) + ": taken as the nearest of " +
                    (most == mtl_unbounded ? "0 and more" : "0 to 1"));
    return nearest;
  }
  void number(const MtlNumber& row, ObjWords words) {
    ObjWords after = words;
    if (after.take() == "-halo") {
      reading_.warn_once("-halo", "d -halo: taken as d");
      words = after;
    }
    if (const auto value = take_last(words))
      *material_.*row.value = clamped(*value, row.least, row.most);
  }
  // One number is a grey.
  void color(const MtlColor& row, ObjWords words) {
    ObjWords first = words;
    const std::string_view word = first.take();
    if (word == "spectral" || word == "xyz")
      return reading_.warn(std::string(row.name) + " " + std::string(word) + ": is not taken");
    std::array<double, 3> channels{};
    std::size_t count = 0;
    for (; count < 3 && (count == 0 || !words.empty()); ++count) {
      const auto value = take(words);
      if (!value) return;
      channels[count] = clamped(*value, 0, row.most);
    }
    if (!words.empty() || count == 2)
      return reading_.fault(FaultKind::malformed, reading_.line(), "one number or three");
    if (count == 1) channels = {channels[0], channels[0], channels[0]};
    *material_.*row.value = Color{channels[0], channels[1], channels[2]};
  }
  void ior(ObjWords words) {
    const auto value = take_last(words);
    if (!value) return;
    if (*value >= 1 && *value <= 10) material_->ior = value;
    else reading_.warn("Ni: an ior outside 1 to 10 is not taken");
  }
  void illumination(ObjWords words) {
    if (const auto value = take_last(words)) material_->illumination = value;
  }

  MtlReading& reading_;
  MtlMaps maps_;
  std::optional<MtlMaterial> material_;
};

}  // namespace

void read_mtl(const ModelFile& file, const ModelFiles& files, bool alone, Faults& faults,
              Model& model) {
  MtlReading reading(file, files, alone, faults, model);
  MtlReader(reading).read();
}

}  // namespace tia
