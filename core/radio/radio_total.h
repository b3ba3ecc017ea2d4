// What the paths of a pair come to together.
#pragma once

#include <optional>
#include <vector>

#include "core/radio/path_field.h"
#include "core/radio/radio_question.h"

namespace tia {

/// RadioTotal: of all paths of a pair; none of a number where it is not defined.
struct RadioTotal {
  std::optional<double> coherent_db,
      incoherent_db;  ///< means over ports of |sum|^2, of sums of ||^2
  std::optional<double> mean_delay_s, delay_spread_s;
  std::optional<double> k_factor_db;  ///< the strongest path's power over all others'
};
/// Of a channel between ports, as PathGain.
struct RadioChannel {
  std::vector<PathGain> frequency, impulse;
};

/// Of paths with gains.
RadioTotal total_of(const std::vector<RadioPath>& paths, int receiver_ports, int transmitter_ports,
                    double unit_metres);
RadioChannel channel_of(const std::vector<RadioPath>& paths, const ChannelQuestion& question,
                        double unit_metres);

}  // namespace tia
