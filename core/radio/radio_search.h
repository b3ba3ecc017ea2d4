// What every question of radio waves goes through: its checks, the search for paths, their gains.
#pragma once

#include <vector>

#include "core/radio/images.h"
#include "core/radio/radio_total.h"

namespace tia {

/// RadioLimits: what one question may take.
struct RadioLimits {
  std::int64_t max_rays = 2'000'000'000;  ///< shot by all transmitters
  std::int64_t max_images = 20'000'000;   ///< of transmitters, mirrored in sequences of faces
  std::int64_t max_paths = 20'000;        ///< of all pairs
};

/// Adds faults of antennas in bodies, or on them. `pointer`: of antenna i's position.
void check_antennas(const RadioWorld& world, const std::vector<Antenna>& antennas,
                    const std::function<std::string(std::size_t)>& pointer, Faults& faults);
/// Adds faults of `image` where a body is curved, and of more rays than the limit.
void check_search(const RadioWorld& world, const RadioQuestion& question, const RadioLimits& limits,
                  const Place& at, Faults& faults);

/// What a question asks of a search, but from where to where.
PathSearch search_of(const RadioQuestion& question);

/// The paths of a search by the question's method, those around edges among them.
/// Errors: InputError (limit); Stopped.
PathsTo paths_from(const RadioWorld& world, const RadioQuestion& question, const PathSearch& search,
                   const Workers& workers);

/// Sets the gains of a pair's paths and leaves out those that are too weak.
/// Returns: what they come to.
RadioTotal settle_paths(std::vector<RadioPath>& paths, const RadioWorld& world,
                        const RadioQuestion& question, const Antenna& transmitter,
                        const Antenna& receiver);

}  // namespace tia
