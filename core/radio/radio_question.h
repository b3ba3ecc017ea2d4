// What is asked of radio waves in a scene.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "core/radio/antenna.h"
#include "core/radio/constants.h"

namespace tia {

/// RadioMethod: how paths are found.
enum class RadioMethod { hybrid, image, sbr };
template <>
struct Names<RadioMethod> {
  static constexpr std::array<std::string_view, 3> names{"hybrid", "image", "sbr"};
};

/// ChannelQuestion: at which frequencies, and at which delays, the channel is told.
struct ChannelQuestion {
  static constexpr std::string_view schema_name = "radio_channel";
  static constexpr std::size_t most = 8192;
  std::vector<double> offsets_hz, taps_s;
  double bandwidth_hz = 20e6;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("offsets_hz", &ChannelQuestion::offsets_hz,
          Spec{.about = "offsets from frequency_hz at which the frequency response is told, of at "
                        "most 8192",
               .unit = "Hz",
               .min = -1e11,
               .max = 1e11});
    visit("taps_s", &ChannelQuestion::taps_s,
          Spec{.about = "delays at which the impulse response is told, of at most 8192",
               .unit = "seconds",
               .min = -1,
               .max = 1});
    visit("bandwidth_hz", &ChannelQuestion::bandwidth_hz,
          Spec{.about = "what the impulse response is limited to: each path is a sinc of it",
               .unit = "Hz",
               .min = 1,
               .max = 1e11});
  }
  void check(const Place& at, Faults& faults) const;
  bool operator==(const ChannelQuestion&) const = default;
};

struct RadioQuestion {
  static constexpr std::size_t most_antennas = 1024;
  static constexpr int deepest = 10;
  std::vector<Antenna> transmitters, receivers;
  double frequency_hz = 0;
  RadioMethod method = RadioMethod::hybrid;
  int max_reflections = 3, max_transmissions = 0, max_diffractions = 0;
  std::int64_t rays = 100'000;
  double min_gain_db = -200, unit_metres = 1;
  std::optional<ChannelQuestion> channel;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    using Q = RadioQuestion;
    visit("transmitters", &Q::transmitters,
          Spec{.about = "what sends, at most 1024", .required = true, .min_items = 1});
    visit("receivers", &Q::receivers,
          Spec{.about = "what receives, at most 1024", .required = true, .min_items = 1});
    visit("frequency_hz", &Q::frequency_hz,
          Spec{.about = "the carrier's",
               .unit = "Hz",
               .min = Wave::least,
               .max = Wave::most,
               .required = true});
    visit("method", &Q::method,
          Spec{.about = "how paths are found: image mirrors the transmitter in sequences of flat "
                        "faces; sbr shoots rays and takes those that pass a receiver within a "
                        "ball; hybrid corrects those rays, by images and on curved bodies by "
                        "Fermat's principle"});
    visit("max_reflections", &Q::max_reflections,
          Spec{.about = "how often a path may be reflected", .min = 0, .max = deepest});
    visit("max_transmissions", &Q::max_transmissions,
          Spec{.about = "through how many walls a path may go: sheets, and bodies of materials "
                        "with through",
               .min = 0,
               .max = deepest});
    visit("max_diffractions", &Q::max_diffractions,
          Spec{.about = "how often a path may be diffracted, by convex edges of flat bodies and "
                        "ends of sheets; then it is not reflected",
               .min = 0,
               .max = 1});
    visit("rays", &Q::rays,
          Spec{.about = "how many rays sbr and hybrid shoot from each transmitter",
               .min = 1000,
               .max = 10'000'000});
    visit("min_gain_db", &Q::min_gain_db,
          Spec{.about = "paths of less gain are left out", .unit = "dB", .min = -1000, .max = 100});
    visit("unit_metres", &Q::unit_metres,
          Spec{.about = "how long a scene unit is", .unit = "metres", .min = 1e-6, .max = 1e6});
    visit("channel", &Q::channel,
          Spec{.about = "asks for the frequency response and the impulse response, too"});
  }
  void check(const Place& at, Faults& faults) const;
  bool operator==(const RadioQuestion&) const = default;
};

}  // namespace tia
