// The paths between all transmitters and receivers of a scene, and what they carry together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/radio/images.h"
#include "core/radio/path_field.h"
#include "core/radio/radio_question.h"
#include "core/scene/scene.h"

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

struct RadioPair {
  std::size_t transmitter = 0, receiver = 0;
  std::vector<RadioPath> paths;
  RadioTotal total;
  std::optional<RadioChannel> channel;
};

struct RadioAnswer {
  std::vector<RadioBody> bodies;
  std::vector<std::string> assumed, warnings;
  std::vector<RadioPair> pairs;  ///< by transmitter, then by receiver
  PathCounts counts;
};

/// RadioLimits: what one question may take.
struct RadioLimits {
  std::int64_t max_rays = 2'000'000'000;  ///< shot by all transmitters
  std::int64_t max_images = 20'000'000;   ///< of transmitters, mirrored in sequences of faces
  std::int64_t max_paths = 20'000;        ///< of all pairs
};

/// Domain: a scene that was read and whose models are resolved; a question that its check has
/// passed. The same answer, to the bit, whoever works.
/// Errors: InputError: antennas in bodies or on their surfaces, `image` where a body is curved, a
/// limit; Stopped.
RadioAnswer radio_paths(const Scene& scene, const RadioQuestion& question,
                        const RadioLimits& limits = {}, const Workers& workers = {});

/// Of paths with gains.
RadioTotal total_of(const std::vector<RadioPath>& paths, int receiver_ports, int transmitter_ports,
                    double unit_metres);
RadioChannel channel_of(const std::vector<RadioPath>& paths, const ChannelQuestion& question,
                        double unit_metres);

/// The answer as JSON, as radio.md lays it down; and its JSON Schema.
Value radio_paths_json(const RadioQuestion& question, const RadioAnswer& answer);
Value radio_paths_schema();

}  // namespace tia
