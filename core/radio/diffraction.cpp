#include "core/radio/diffraction.h"

#include <cmath>

#include "core/math/onb.h"

namespace tia {
namespace {

constexpr double half_root_2 = 0.70710678118654752;
constexpr Complex eighth_turn{half_root_2, half_root_2};  // e^{j pi/4}
constexpr Complex imaginary{0, 1};

// By the power series of the integral from 0 to the root. Domain: root <= 2.
Complex transition_by_series(double root) {
  const double x = root * root;
  Complex term{root, 0}, sum = term;  // (-j)^m root^(2m+1)/(m! (2m+1))
  for (int m = 1; m < 60; ++m) {
    term = term * Complex{0, -x / m};
    sum = sum + term * (1.0 / (2 * m + 1));
  }
  // The whole integral is sqrt(pi)/2 e^{-j pi/4}.
  const double half = std::sqrt(pi) / 2 * half_root_2;
  return imaginary * (2 * root) * turn(x) * (Complex{half, -half} - sum);
}

// z K(z), z = e^{j pi/4} root, K the continued fraction of the complementary error function.
// Source: Abramowitz, Stegun, "Handbook of Mathematical Functions" (1964), 7.1.14.
Complex transition_by_fraction(double root) {
  const Complex z = eighth_turn * root;
  Complex below = z;
  for (int m = 120; m > 0; --m) below = z + Complex{m / 2.0, 0} / below;
  return z / below;
}

// cot((pi +- beta)/2n) F(k L a), which has a limit where the cotangent has none.
// `sign`: of beta in the cotangent.
Complex boundary_term(double beta, double sign, double n, double k_length) {
  const double turns = std::nearbyint((sign * pi + beta) / (2 * pi * n));  // N of that sign
  const double off = (2 * pi * n * turns - beta) / 2;
  const double root = std::sqrt(2 * k_length) * std::fabs(cos_of(off));
  const double angle = (pi + sign * beta) / (2 * n);
  const double sine = sin_of(angle);
  if (std::fabs(sine) > 1e-9) return transition(root) * (cos_of(angle) / sine);
  const double side = sine < 0 ? -1 : 1;
  return eighth_turn * (n * side * std::sqrt(2 * pi * k_length));
}

Polarized face_reflection(double cosine, const RadioBody& body, const Wave& wave) {
  if (body.matter.kind == RadioMatter::conductor) return mirrored;
  if (body.sheet) return sheet(body.matter.eta, cosine, body.thickness, wave).reflected;
  return half_space(body.matter.eta, cosine);
}

// The vectors across the ray and the edge, and along the edge as far as across the ray.
struct EdgeBasis {
  Vec3d across, beside;
};
EdgeBasis basis_of(const Vec3d& along, const Vec3d& radial, const Vec3d& way) {
  const Vec3d across = unit(cross(along, radial));
  return {across, cross(across, way)};
}

}  // namespace

Complex transition(double root) {
  return root <= 2 ? transition_by_series(root) : transition_by_fraction(root);
}

Polarized edge_coefficients(const EdgeWay& way, double n, const RadioBody& body, const Wave& wave) {
  const double k = wave.number();
  const double k_length =
      k * way.before * way.behind * way.sine * way.sine / (way.before + way.behind);
  const double less = way.diffracted - way.incident, more = way.diffracted + way.incident;
  const auto cosine = [&](double a, double b) {
    return std::fmin(1, std::sqrt(std::fabs(sin_of(a) * sin_of(b))) * way.sine);
  };
  const Polarized r0 = face_reflection(cosine(way.incident, way.diffracted), body, wave);
  const Polarized rn =
      face_reflection(cosine(n * pi - way.incident, n * pi - way.diffracted), body, wave);
  const Complex straight =
      boundary_term(less, 1, n, k_length) + boundary_term(less, -1, n, k_length);
  const Complex at_0 = boundary_term(more, -1, n, k_length),
                at_n = boundary_term(more, 1, n, k_length);
  const Complex factor = Complex{-half_root_2, half_root_2} *  // -e^{-j pi/4}
                         (1 / (2 * n * std::sqrt(2 * pi * k) * way.sine));
  return {factor * (straight + r0.perpendicular * at_0 + rn.perpendicular * at_n),
          factor * (straight + r0.parallel * at_0 + rn.parallel * at_n)};
}

std::optional<RadioPath> edge_path(const RadioEdge& edge, int number, const Vec3d& from,
                                   const Vec3d& to) {
  const auto split = [&](const Vec3d& p) {
    const double at = dot(p - edge.from, edge.along);
    return std::pair(at, length(p - edge.from - edge.along * at));
  };
  const auto [from_at, from_off] = split(from);
  const auto [to_at, to_off] = split(to);
  if (!(from_off > 0 && to_off > 0)) return std::nullopt;
  const double at = from_at + (to_at - from_at) * (from_off / (from_off + to_off));
  if (!(at >= 0 && at < edge.size)) return std::nullopt;
  const Vec3d p = edge.from + edge.along * at;
  if (edge.angle_of(from - p) > edge.n * pi || edge.angle_of(to - p) > edge.n * pi)
    return std::nullopt;
  const double before = length(p - from), behind = length(to - p);
  RadioPath path{from, to, {}, before + behind};
  const double cosine = std::fabs(dot(p - from, edge.along)) / before;
  path.interactions.push_back(
      {RadioKind::diffraction, edge.body, edge.element, p, edge.normal, cosine, 0, number});
  path.tube = std::sqrt(before * behind * (before + behind));
  return path;
}

WaveField after_edge(const RadioInteraction& at, const RadioEdge& edge, const RadioPath& path,
                     const RadioBody& body, const LinkWave& link, const WaveField& field) {
  const Vec3d back = path.from - at.point, away = path.to - at.point;
  const double u = link.unit_metres;
  const EdgeWay way{edge.angle_of(back), edge.angle_of(away), std::sqrt(1 - at.cosine * at.cosine),
                    length(back) * u, length(away) * u};
  const Polarized d = edge_coefficients(way, edge.n, body, link.wave);
  const EdgeBasis in = basis_of(edge.along, back, unit(-back)),
                  out = basis_of(edge.along, away, unit(away));
  const double scale = -1 / std::sqrt(u);  // `tube` has three halves of a scene unit's power
  WaveField left;
  left.add(out.beside, d.perpendicular * field.along(in.beside) * scale);
  left.add(out.across, d.parallel * field.along(in.across) * scale);
  return left;
}

}  // namespace tia
