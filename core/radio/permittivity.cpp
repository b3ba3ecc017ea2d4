#include "core/radio/permittivity.h"

#include "core/input/json.h"
#include "core/math/powers.h"

namespace tia {
namespace {

Complex lossy(double real, double conductivity, const Wave& wave) {
  return {real, -conductivity / (2 * pi * wave.frequency * vacuum_permittivity)};
}
RadioMatter matter_of(const ItuRadio& itu, const Wave& wave) {
  const ItuRow& row = row_of(itu.name);
  const double ghz = wave.frequency / 1e9;
  const Complex eta = lossy(row.a * pow_of(ghz, row.b), row.c * pow_of(ghz, row.d), wave);
  return {RadioMatter::dielectric, eta, itu.thickness, itu.through};
}
RadioMatter matter_of(const DielectricRadio& is, const Wave& wave) {
  return {RadioMatter::dielectric, lossy(is.relative_permittivity, is.conductivity, wave),
          is.thickness, is.through};
}
RadioMatter matter_of(const ConductorRadio&, const Wave&) {
  return {RadioMatter::conductor, {1, 0}, {}, false};
}
RadioMatter matter_of(const AirRadio&, const Wave&) { return {RadioMatter::air, {1, 0}, {}, true}; }

}  // namespace

RadioMatter matter_of(const RadioMaterial& material, const Wave& wave) {
  return std::visit([&](const auto& kind) { return matter_of(kind, wave); }, material.kind);
}

std::string band_warning(const RadioMaterial& material, const Wave& wave) {
  const auto* itu = std::get_if<ItuRadio>(&material.kind);
  if (itu == nullptr) return "";
  const ItuRow& row = row_of(itu->name);
  const double ghz = wave.frequency / 1e9;
  if (row.low_ghz <= ghz && ghz <= row.high_ghz) return "";
  return std::string(row.name) + " was measured from " + number_text(row.low_ghz) + " to " +
         number_text(row.high_ghz) + " GHz, not at " + number_text(ghz) + " GHz";
}

}  // namespace tia
