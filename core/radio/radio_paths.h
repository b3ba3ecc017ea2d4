// The paths between all transmitters and receivers of a scene, and what they carry together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/radio/radio_search.h"
#include "core/radio/radio_total.h"
#include "core/scene/scene.h"

namespace tia {

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

/// Domain: a scene that was read and whose models are resolved; a question that its check has
/// passed. The same answer, to the bit, whoever works.
/// Errors: InputError: antennas in bodies or on their surfaces, `image` where a body is curved, a
/// limit; Stopped.
RadioAnswer radio_paths(const Scene& scene, const RadioQuestion& question,
                        const RadioLimits& limits = {}, const Workers& workers = {});

/// The answer as JSON, as radio.md lays it down; and its JSON Schema.
Value radio_paths_json(const RadioQuestion& question, const RadioAnswer& answer);
Value radio_paths_schema();

}  // namespace tia
