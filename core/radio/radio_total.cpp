#include "core/radio/radio_total.h"

#include <algorithm>
#include <cmath>

#include "core/radio/decibels.h"

namespace tia {
namespace {

void add(PathGain& sum, const PathGain& gain, const Complex& factor) {
  for (std::size_t r = 0; r < 2; ++r)
    for (std::size_t t = 0; t < 2; ++t) sum[r][t] = sum[r][t] + gain[r][t] * factor;
}

double delay_of(const RadioPath& path, double unit_metres) {
  return path.length * unit_metres / speed_of_light;
}

// sin(pi x)/(pi x).
double sinc(double x) {
  if (std::fabs(x) < 1e-8) return 1;
  return sin_of(pi * x) / (pi * x);
}

std::optional<double> told(double decibels) {
  return std::isfinite(decibels) ? std::optional(decibels) : std::nullopt;
}

}  // namespace

RadioTotal total_of(const std::vector<RadioPath>& paths, int receiver_ports, int transmitter_ports,
                    double unit_metres) {
  PathGain sum{};
  double power = 0, strongest = 0, delay = 0, square = 0;
  for (const RadioPath& path : paths) {
    const double own = power_of(path.gain, receiver_ports, transmitter_ports);
    add(sum, path.gain, {1, 0});
    power += own;
    strongest = std::max(strongest, own);
    delay += own * delay_of(path, unit_metres);
  }
  RadioTotal total;
  if (!(power > 0)) return total;
  delay /= power;
  for (const RadioPath& path : paths) {
    const double off = delay_of(path, unit_metres) - delay;
    square += power_of(path.gain, receiver_ports, transmitter_ports) * off * off;
  }
  total.coherent_db = told(decibels_of(power_of(sum, receiver_ports, transmitter_ports)));
  total.incoherent_db = told(decibels_of(power));
  total.mean_delay_s = delay;
  total.delay_spread_s = std::sqrt(square / power);
  if (power > strongest) total.k_factor_db = told(decibels_of(strongest / (power - strongest)));
  return total;
}

RadioChannel channel_of(const std::vector<RadioPath>& paths, const ChannelQuestion& question,
                        double unit_metres) {
  RadioChannel channel;
  for (const double offset : question.offsets_hz) {
    PathGain& sum = channel.frequency.emplace_back();
    for (const RadioPath& path : paths)
      add(sum, path.gain, turn(-2 * pi * offset * delay_of(path, unit_metres)));
  }
  for (const double tap : question.taps_s) {
    PathGain& sum = channel.impulse.emplace_back();
    for (const RadioPath& path : paths)
      add(sum, path.gain, {sinc(question.bandwidth_hz * (tap - delay_of(path, unit_metres))), 0});
  }
  return channel;
}

}  // namespace tia
