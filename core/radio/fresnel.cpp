#include "core/radio/fresnel.h"

#include "core/math/powers.h"

namespace tia {
namespace {

constexpr Complex full{1, 0};

// q, the normal component of the wave vector inside over that of empty space.
Complex inner_cosine(const Complex& eta, double cosine) {
  return sqrt_of({eta.re - (1 - cosine * cosine), eta.im});
}
// e^{-j phase}; of lossy phases, im <= 0, what is left.
Complex passed(const Complex& phase) { return turn(-phase.re) * exp_of(phase.im); }

Complex reflected_by_sheet(const Complex& r, const Complex& twice) {
  return r * (full - twice) / (full - r * r * twice);
}
Complex through_sheet(const Complex& r, const Complex& once, const Complex& twice) {
  return (full - r * r) * once / (full - r * r * twice);
}

}  // namespace

Polarized half_space(const Complex& eta, double cosine) {
  const Complex q = inner_cosine(eta, cosine), out{cosine, 0}, in = eta * cosine;
  return {(out - q) / (out + q), (in - q) / (in + q)};
}

Polarized half_space_through(const Complex& eta, double cosine) {
  const Polarized r = half_space(eta, cosine);
  const auto through = [](const Complex& each) { return sqrt_of(full - each * each); };
  return {through(r.perpendicular), through(r.parallel)};
}

Complex excess_of(const Complex& eta, double cosine) {
  return inner_cosine(eta, cosine) - Complex{cosine, 0};
}

SheetFactors sheet(const Complex& eta, double cosine, double thickness, const Wave& wave) {
  const Polarized r = half_space(eta, cosine);
  const double kd = wave.number() * thickness;
  const Complex once = passed(excess_of(eta, cosine) * kd);
  const Complex twice = passed(inner_cosine(eta, cosine) * (2 * kd));
  return {{reflected_by_sheet(r.perpendicular, twice), reflected_by_sheet(r.parallel, twice)},
          {through_sheet(r.perpendicular, once, twice), through_sheet(r.parallel, once, twice)}};
}

}  // namespace tia
