// Writes core/materials/albedo_tables.inc: the share of light that single scattering sends on, by
// the visible normals' mean of what each facet does. The command stands in its first lines.
#include <cstdio>
#include <vector>

#include "core/materials/albedo_tables.h"
#include "core/materials/grain_albedo.h"
#include "core/materials/microfacet.h"
#include "core/materials/sheen.h"
#include "core/math/deterministic.h"
#include "core/math/sobol.h"

namespace {

using namespace tia;

// Calls to(h) with the normals for Hammersley's points. A grid would not do: those that send light
// below the surface lie along the square's edge, nearer to it than the middles of its cells.
template <class F>
void each_normal(const Ggx<double>& ggx, const Vec3d& wo, int count, F to) {
  for (int i = 0; i < count; ++i) {
    const double v = reversed_bits(static_cast<std::uint32_t>(i)) * 0x1p-32;
    to(ggx.sample(wo, (i + 0.5) / count, v + 0x1p-33));
  }
}
Vec3d direction_of(double mu) { return {std::sqrt(1 - mu * mu), 0, mu}; }

struct Pair {
  double a = 0, b = 0;
};
// What facets reflect, for Fresnel's shares 1 - (1 - c)^5 and (1 - c)^5.
Pair reflected(double mu, double alpha) {
  constexpr int count = 1 << 16;
  const Ggx<double> ggx{alpha, alpha};
  const Vec3d wo = direction_of(mu);
  Pair sum;
  each_normal(ggx, wo, count, [&](const Vec3d& h) {
    const double c = dot(wo, h);
    const Vec3d wi = h * (2 * c) - wo;
    if (wi.z <= 0) return;
    const double share = ggx.visible(wo, wi) / ggx.visible(wo), w = schlick_weight(c);
    sum.a += share * (1 - w), sum.b += share * w;
  });
  return {sum.a / count, sum.b / count};
}
// What facets of a dielectric reflect and let pass together.
double passed_on(double mu, double alpha, double eta) {
  constexpr int count = 1 << 14;
  const Ggx<double> ggx{alpha, alpha};
  const Vec3d wo = direction_of(mu);
  double sum = 0;
  each_normal(ggx, wo, count, [&](const Vec3d& h) {
    const double c = dot(wo, h), g = ggx.visible(wo);
    const Dielectric<double> at(c, eta);
    const Vec3d wi = h * (2 * c) - wo;
    if (wi.z > 0) sum += at.reflected * ggx.visible(wo, wi) / g;
    if (at.total) return;
    const Vec3d wt = refracted(wo, h, c, eta, at.cos_t);
    if (wt.z < 0) sum += (1 - at.reflected) * ggx.visible(wo, wt) / g;
  });
  return sum / count;
}
// What velvet's fibres reflect.
double sheen(double mu, double alpha) {
  constexpr int side = 256;
  const Vec3d wo = direction_of(mu);
  double sum = 0;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const double z = (i + 0.5) / side, turn = 2 * pi * (j + 0.5) / side, r = std::sqrt(1 - z * z);
      sum += sheen_cos(wo, Vec3d{r * std::cos(turn), r * std::sin(turn), z}, alpha) * 2 * pi;
    }
  return sum / (side * side);
}

void print(const char* name, const std::vector<double>& values) {
  std::printf("inline constexpr float %s[] = {", name);
  for (std::size_t i = 0; i < values.size(); ++i)
    std::printf("%s%.4fF,", i % 14 == 0 ? "\n" : " ", values[i]);
  std::printf("\n};\n");
}
// Twice the integral of mu times a row's values, as they are interpolated.
template <class F>
double average(F value) {
  constexpr int n = 2048;
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += value((i + 0.5) / n) * 2 * (i + 0.5) / n / n;
  return sum;
}
// The mean of value(w), by the cosine, of facets that are alike in the four quarters.
template <class F>
double quarter_mean(F value) {
  constexpr int n = 32;
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const double square = (i + 0.5) / n, turn = pi / 2 * (k + 0.5) / n;
      const double r = std::sqrt(1 - square);
      sum += value(Vec3d{r * std::cos(turn), r * std::sin(turn), std::sqrt(square)});
    }
  return sum / (n * n);
}
double node(int i, int n) { return std::max(static_cast<double>(i) / (n - 1), 1e-3); }

}  // namespace

int main() {
  using namespace tia::albedo_tables;
  std::vector<double> a, b, mean_a, mean_b, velvet, glass, mean_glass;
  const auto between = [](const double* row, int n, double mu) {
    const double x = std::sqrt(mu) * (n - 1);
    const int i = std::min(static_cast<int>(x), n - 2);
    return row[i] + (row[i + 1] - row[i]) * (x - i);
  };
  for (int r = 0; r < metal_nodes; ++r) {
    for (int m = 0; m < metal_nodes; ++m) {
      const double mu = node(m, metal_nodes), rough = node(r, metal_nodes);
      const Pair pair = reflected(mu * mu, std::max(rough * rough, 1e-4));
      a.push_back(pair.a), b.push_back(pair.b);
    }
    const std::size_t row = static_cast<std::size_t>(r) * metal_nodes;
    mean_a.push_back(average([&](double mu) { return between(&a[row], metal_nodes, mu); }));
    mean_b.push_back(average([&](double mu) { return between(&b[row], metal_nodes, mu); }));
  }
  for (int r = 0; r < sheen_nodes; ++r)
    for (int m = 0; m < sheen_nodes; ++m) {
      const double mu = node(m, sheen_nodes), rough = node(r, sheen_nodes);
      velvet.push_back(sheen(mu * mu, std::max(rough * rough, static_cast<double>(least_sheen))));
    }
  for (int e = 0; e < glass_indices; ++e)
    for (int r = 0; r < glass_nodes; ++r) {
      for (int m = 0; m < glass_nodes; ++m) {
        const double mu = node(m, glass_nodes), rough = node(r, glass_nodes);
        const double f = index_of_node(e);
        glass.push_back(passed_on(mu * mu, std::max(rough * rough, 1e-4), (1 + f) / (1 - f)));
      }
      const double* row = &glass[glass.size() - glass_nodes];
      mean_glass.push_back(average([&](double mu) { return between(row, glass_nodes, mu); }));
    }
  const auto grains = [](int n, auto to) {
    const auto alpha = [n](int i) { return std::max(node(i, n) * node(i, n), 1e-4); };
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) to(Ggx<double>{alpha(x), alpha(y)});
  };
  std::vector<double> grain_a, grain_b, grain_glass;
  grains(grain_nodes, [&](const Ggx<double>& ggx) {
    grain_a.push_back(quarter_mean([&](const Vec3d& w) { return grain_albedo(ggx, w).a; }));
    grain_b.push_back(quarter_mean([&](const Vec3d& w) { return grain_albedo(ggx, w).b; }));
  });
  for (int e = 0; e < glass_indices; ++e)
    grains(grain_glass_nodes, [&](const Ggx<double>& ggx) {
      const double f = index_of_node(e), eta = (1 + f) / (1 - f);
      grain_glass.push_back(
          quarter_mean([&](const Vec3d& w) { return grain_glass_albedo(ggx, w, eta); }));
    });
  std::printf("// Made by: cmake --build build/release --target albedo_tables\n");
  std::printf("//          build/release/tests/albedo_tables > core/materials/albedo_tables.inc\n");
  std::printf("// clang-format off\n");
  print("reflected_a", a), print("reflected_b", b), print("mean_a", mean_a),
      print("mean_b", mean_b);
  print("velvet", velvet), print("glass", glass), print("mean_glass", mean_glass);
  print("mean_grain_a", grain_a), print("mean_grain_b", grain_b);
  print("mean_grain_glass", grain_glass);
}
